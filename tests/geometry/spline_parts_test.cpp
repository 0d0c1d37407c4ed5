// The elements of the paths: splines' derivatives at their knots, rotation vectors and the rotation.
#include "geometry/knot_rates.hpp"
#include "geometry/pose_path.hpp"
#include "language/paths/path_arm.hpp"

namespace mrroc {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::pick;
using fakes::random_vector;

constexpr int kSplines = 300;

struct Spline {
  Spline(SplineOrder order, SplineEnds ends, int count) {
    values = Eigen::MatrixXd(count, 2);
    for (int i = 0; i < count; ++i) {
      if (i > 0) knots.push_back(knots.back() + 0.01 * pick(20, 200));
      values.row(i) << 0.01 * pick(-100, 100), 0.01 * pick(-100, 100);
    }
    rates = knot_rates(order, ends, knots, values);
    for (int i = 0; i + 1 < count; ++i) {
      const auto state = [&](int k) {
        return QuinticPiece<2>::State{values.row(k), rates.first.row(k), rates.second.row(k)};
      };
      pieces.emplace_back(state(i), state(i + 1),
                          knots[static_cast<std::size_t>(i) + 1] - knots[static_cast<std::size_t>(i)]);
    }
  }
  /// The fourth derivative, by differences of the third.
  static Eigen::Vector2d fourth(const QuinticPiece<2>& piece, double s) {
    const double h = 1e-4 * piece.length();
    return (piece.third(s + h) - piece.third(s - h)) / (2 * h);
  }
  std::vector<double> knots{0};
  Eigen::MatrixXd values;
  KnotRates rates;
  std::vector<QuinticPiece<2>> pieces;
};

TEST(KnotRates, CubicSplineHasPiecesOfDegreeThreeAndAContinuousSecondDerivative) {
  check_property(kSplines, [] {
    const Spline spline(SplineOrder::cubic, SplineEnds::straight, pick(2, 12));
    for (const auto& piece : spline.pieces) {
      const Eigen::Vector2d third = piece.third(0);
      RC_ASSERT((piece.third(piece.length()) - third).norm() < 1e-6 * (1 + third.norm()));
      RC_ASSERT((piece.third(0.3 * piece.length()) - third).norm() < 1e-6 * (1 + third.norm()));
    }
    RC_ASSERT(spline.rates.second.row(0).norm() < 1e-9);
    RC_ASSERT(spline.rates.second.bottomRows(1).norm() < 1e-9);
  });
}

TEST(KnotRates, QuinticSplineHasContinuousThirdAndFourthDerivatives) {
  check_property(kSplines, [] {
    for (const SplineEnds ends : {SplineEnds::straight, SplineEnds::at_rest}) {
      const Spline spline(SplineOrder::quintic, ends, pick(2, 12));
      for (std::size_t i = 1; i < spline.pieces.size(); ++i) {
        const auto &before = spline.pieces[i - 1], &after = spline.pieces[i];
        const Eigen::Vector2d third = after.third(0), fourth = Spline::fourth(after, 0);
        RC_ASSERT((before.third(before.length()) - third).norm() < 1e-6 * (1 + third.norm()));
        RC_ASSERT((Spline::fourth(before, before.length()) - fourth).norm() < 1e-4 * (1 + fourth.norm()));
      }
      RC_ASSERT(spline.rates.second.row(0).norm() < 1e-9);
      RC_ASSERT(spline.rates.second.bottomRows(1).norm() < 1e-9);
      if (ends == SplineEnds::at_rest) {
        RC_ASSERT(spline.rates.first.row(0).norm() < 1e-9);
        RC_ASSERT(spline.rates.first.bottomRows(1).norm() < 1e-9);
      } else {
        RC_ASSERT(spline.pieces.front().third(0).norm() < 1e-6);
      }
    }
  });
}

TEST(KnotRates, CollinearDataGiveAStraightLine) {
  check_property(kSplines, [] {
    std::vector<double> knots{0};
    const int count = pick(2, 10);
    for (int i = 1; i < count; ++i) knots.push_back(knots.back() + 0.01 * pick(1, 300));
    const double slope = 0.1 * pick(-20, 20);
    Eigen::MatrixXd values(count, 1);
    for (int i = 0; i < count; ++i) values(i, 0) = 3 + slope * knots[static_cast<std::size_t>(i)];
    for (const SplineOrder order : {SplineOrder::cubic, SplineOrder::quintic}) {
      const KnotRates rates = knot_rates(order, SplineEnds::straight, knots, values);
      RC_ASSERT((rates.first.array() - slope).abs().maxCoeff() < 1e-6);
      RC_ASSERT(rates.second.cwiseAbs().maxCoeff() < 1e-4);
    }
  });
}

/// A variable rotation vector: phi + phi' t + phi'' t^2 / 2.
Eigen::Matrix3d rotation_at(const Vector3d& vector, const Vector3d& first, const Vector3d& second, double t) {
  return exp_rotation(vector + t * first + 0.5 * t * t * second);
}

TEST(RotationRates, AreTheDerivativesOfTheRotationAndHaveAnInverse) {
  check_property(kSplines, [] {
    // also near 0 and near the largest rotation
    const Vector3d vector =
        random_vector(1).normalized() * (pick(0, 3) == 0 ? 1e-3 * pick(0, 100) : 0.01 * pick(0, 310));
    if (!vector.allFinite()) return;
    const Vector3d first = random_vector(1), second = random_vector(2);
    const Turning turning = turning_of(vector, first, second);
    const double h = 1e-4;
    const Eigen::Matrix3d now = exp_rotation(vector);
    const Vector3d before = rotation_vector(now * rotation_at(vector, first, second, -h).transpose()) / h;
    const Vector3d after = rotation_vector(rotation_at(vector, first, second, h) * now.transpose()) / h;
    RC_ASSERT((0.5 * (before + after) - turning.velocity).norm() < 1e-6);
    RC_ASSERT(((after - before) / h - turning.rate).norm() < 1e-5);
    const Turning back = vector_rates_of(vector, turning);
    RC_ASSERT((back.velocity - first).norm() < 1e-9);
    RC_ASSERT((back.rate - second).norm() < 1e-9);
  });
}

TEST(RotationRates, SeriesAndFractionsAgree) {
  const Vector3d first(0.3, -0.5, 0.7), second(-1, 0.2, 0.4);
  const Vector3d axis = Vector3d(1, 2, -1).normalized();
  const Turning below = turning_of((0.1 - 1e-12) * axis, first, second),
                above = turning_of((0.1 + 1e-12) * axis, first, second);
  EXPECT_LT((below.velocity - above.velocity).norm(), 1e-11);
  EXPECT_LT((below.rate - above.rate).norm(), 1e-10);
}

PathPose random_place() {
  PathPose place{fakes::random_pose(0.3, 1.5), {}, {}};
  place.first << random_vector(0.2), random_vector(0.5);
  place.second << random_vector(0.5), random_vector(1);
  return place;
}

// two pieces with a common end: pose, velocity and acceleration are continuous there
TEST(PosePiece, HasTheGivenDerivativesAtItsEnds) {
  check_property(kSplines, [] {
    const PathPose from = random_place(), to = random_place();
    const double length = 0.1 * pick(5, 30), h = 1e-5 * length;
    const PosePiece piece(from, to, length);
    for (const bool end : {false, true}) {
      const PathPose& given = end ? to : from;
      const PathPose inside = piece.at(end ? length - h : h);
      RC_ASSERT(fakes::distance(inside.pose, given.pose) < 1e-4);
      RC_ASSERT(fakes::angle(inside.pose, given.pose) < 1e-4);
      RC_ASSERT((inside.first - given.first).norm() < 2e-3);
      RC_ASSERT((inside.second - given.second).norm() < 5e-2);
    }
  });
}

TEST(PosePiece, DerivativesMatchDifferences) {
  check_property(kSplines, [] {
    const double length = 0.1 * pick(5, 30), h = 1e-4 * length;
    const PosePiece piece(random_place(), random_place(), length);
    const double s = 0.01 * length * pick(1, 99);
    const PathPose before = piece.at(s - h), there = piece.at(s), after = piece.at(s + h);
    const Vector3d way = after.pose.translation() - before.pose.translation();
    const Vector3d turn = rotation_vector(after.pose.linear() * before.pose.linear().transpose());
    RC_ASSERT((way / (2 * h) - there.first.head<3>()).norm() < 1e-4);
    RC_ASSERT((turn / (2 * h) - there.first.tail<3>()).norm() < 1e-4);
    RC_ASSERT(((after.first - before.first) / (2 * h) - there.second).norm() < 1e-2);
  });
}

TEST(PosePiece, BetweenEndsOnALineItIsTheLine) {
  check_property(kSplines, [] {
    const Pose from = fakes::random_pose(0.3, 1), to = fakes::random_pose(0.3, 1);
    const double length = 0.1 * pick(5, 30);
    const LineEnds line = line_between(from, to, length);
    const PosePiece piece(line.from, line.to, length);
    const double u = 0.01 * pick(0, 100);
    const PathPose there = piece.at(u * length);
    RC_ASSERT((there.pose.translation() - (1 - u) * from.translation() - u * to.translation()).norm() < 1e-12);
    RC_ASSERT(
        rotation_vector(there.pose.linear() * (exp_rotation(u * turn_between(from, to)) * from.linear()).transpose())
            .norm() < 1e-12);
    RC_ASSERT((there.first - line.from.first).norm() < 1e-9);
    RC_ASSERT(there.second.norm() < 1e-9);
  });
}

}  // namespace
}  // namespace mrroc
