#include "engraving/surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "language/property.hpp"
#include "mrroc/errors.hpp"
#include "tasks/engraving/board.hpp"

namespace engraving {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

/// Centres of a ball that touches the polynomial of `c` (rows x, columns y, in m) over 0.2 x 0.05 m.
struct Polynomial {
  Eigen::MatrixXd c;
  double at(double x, double y) const {
    double height = 0;
    for (int i = 0; i < c.rows(); ++i)
      for (int j = 0; j < c.cols(); ++j) height += c(i, j) * std::pow(x / 0.1, i) * std::pow(y / 0.025, j);
    return height;
  }
  Vector3d normal(double x, double y) const {
    constexpr double kStep = 1e-6;
    return Vector3d((at(x - kStep, y) - at(x + kStep, y)) / (2 * kStep),
                    (at(x, y - kStep) - at(x, y + kStep)) / (2 * kStep), 1)
        .normalized();
  }
};

TEST(Surface, FindsAPolynomialOfItsDegreesFromTheCentresOfABall) {
  mrroc::fakes::check_property(200, [] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::uniform_real_distribution<double> number(-0.001, 0.001);
    const int columns = *rc::gen::inRange(1, 9), rows = *rc::gen::inRange(1, 6);
    const int a = std::min(columns - 1, 2 * columns / 3), b = std::min(rows - 1, 2 * rows / 3);
    Polynomial truth{Eigen::MatrixXd::NullaryExpr(a + 1, b + 1, [&] { return number(random); })};
    const double radius = *rc::gen::elementOf(std::vector<double>{0.0, 0.001, 0.002});
    std::vector<Vector3d> centres;
    for (const Vector2d& place : grid({0.2, 0.05}, columns, rows)) {
      const Vector3d point(place.x(), place.y(), truth.at(place.x(), place.y()));
      centres.emplace_back(point + radius * truth.normal(point.x(), point.y()));
    }
    const Surface found(centres, radius, columns, rows);
    RC_ASSERT(found.residual() < 1e-7);
    for (int i = 0; i < 20; ++i) {
      const double x = 90 * number(random), y = 20 * number(random);
      RC_ASSERT(std::abs(found.height(x, y) - truth.at(x, y)) < 2e-7);
      RC_ASSERT((found.normal(x, y) - truth.normal(x, y)).norm() < 2e-4);
    }
  });
}

TEST(Surface, FindsTheBoardOfTheTaskWithin20MicrometresFromTouchesThatAreOffBySix) {
  std::mt19937 random{3};
  std::normal_distribution<double> noise(0, 6e-6);
  constexpr double kBall = 0.001;
  std::vector<Vector3d> centres;
  for (const Vector2d& place : grid({0.18, 0.045}, 11, 4)) {
    const double u = place.x(), v = place.y();
    centres.emplace_back(Vector3d(u, v, mrroc::test::board_height(u, v) + noise(random)) +
                         kBall * mrroc::test::board_normal(u, v));
  }
  const Surface found(centres, kBall, 11, 4);
  for (double u = -0.08; u <= 0.08; u += 0.004) {
    for (double v = -0.013; v <= 0.013; v += 0.002)
      EXPECT_NEAR(found.height(u, v), mrroc::test::board_height(u, v), 2e-5) << u << " " << v;
  }
}

TEST(Surface, ToolIsNormalToTheSurfaceWithItsTipAtTheDepth) {
  const Surface slope({{0, 0, 0}, {0.1, 0, 0.01}, {0, 0.1, 0.02}, {0.1, 0.1, 0.03}}, 0, 2, 2);
  const mrroc::Pose tool = slope.tool_at({0.05, 0.02}, 0.001);
  const Vector3d normal = Vector3d(-0.1, -0.2, 1).normalized();
  EXPECT_LT((tool.linear() * Vector3d::UnitZ() + normal).norm(), 1e-12);
  EXPECT_LT((tool.translation() - Vector3d(0.05, 0.02, 0.009) + 0.001 * normal).norm(), 1e-12);
  EXPECT_NEAR((tool.linear() * Vector3d::UnitX()).y(), 0, 1e-12);
  EXPECT_LT((tool.linear().transpose() * tool.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_NEAR(tool.linear().determinant(), 1, 1e-12);
}

TEST(Surface, SinglePointIsAFlatSurface) {
  const Surface flat({{0.05, 0, 0.101}}, 0.001, 1, 1);
  EXPECT_NEAR(flat.height(0.1, 0.05), 0.1, 1e-15);
  EXPECT_EQ(flat.normal(0.1, 0.05), Vector3d::UnitZ());
}

TEST(Surface, RefusesPointsThatDoNotDetermineIt) {
  EXPECT_THROW(Surface({{0, 0, 0}, {1, 0, 0}}, 0, 2, 2), mrroc::NonFatalError);
  EXPECT_THROW(Surface({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, 0, 2, 2), mrroc::NonFatalError);
  EXPECT_THROW(grid({1, 1}, 0, 3), mrroc::NonFatalError);
}

TEST(Surface, GridTraversesItsColumnsInAlternatingDirections) {
  const std::vector<Vector2d> places = grid({2, 4}, 2, 3);
  const std::vector<Vector2d> expected{{-1, -2}, {-1, 0}, {-1, 2}, {1, 2}, {1, 0}, {1, -2}};
  EXPECT_EQ(places, expected);
  EXPECT_EQ(grid({2, 4}, 1, 1), std::vector<Vector2d>{Vector2d::Zero()});
}

}  // namespace
}  // namespace engraving
