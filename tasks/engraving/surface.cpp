#include "engraving/surface.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>

#include "mrroc/errors.hpp"

namespace engraving {

std::vector<Eigen::Vector2d> grid(const Eigen::Vector2d& size, int columns, int rows) {
  if (columns < 1 || rows < 1) {
    throw mrroc::NonFatalError(mrroc::ErrorCode::invalid_argument,
                               std::string("a grid of ")
                                   .append(std::to_string(columns) + " columns and " + std::to_string(rows))
                                   .append(" rows, expected 1 or more of each"));
  }
  const auto part = [](int i, int count) { return count > 1 ? i / (count - 1.0) - 0.5 : 0.0; };
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < columns * rows; ++i) {
    const int column = i / rows, row = column % 2 == 0 ? i % rows : rows - 1 - i % rows;
    places.emplace_back(size.x() * part(column, columns), size.y() * part(row, rows));
  }
  return places;
}

Surface::Surface(const std::vector<Eigen::Vector3d>& centres, double radius, int along_x, int along_y)
    : degree_x_(std::min(along_x - 1, 2 * along_x / 3)), degree_y_(std::min(along_y - 1, 2 * along_y / 3)) {
  if (along_x < 1 || along_y < 1 ||
      centres.size() < static_cast<std::size_t>(along_x) * static_cast<std::size_t>(along_y)) {
    throw mrroc::NonFatalError(mrroc::ErrorCode::invalid_argument,
                               std::string("a surface through ")
                                   .append(std::to_string(centres.size()) + " points, expected a grid of ")
                                   .append(std::to_string(along_x) + " x " + std::to_string(along_y)));
  }
  Eigen::Vector2d low = centres.front().head<2>(), high = low;
  for (const auto& centre : centres) {
    low = low.cwiseMin(centre.head<2>());
    high = high.cwiseMax(centre.head<2>());
  }
  middle_ = 0.5 * (low + high);
  half_ = (0.5 * (high - low)).cwiseMax(1e-3);  // of a single column: any length
  std::vector<Eigen::Vector3d> points = centres;
  for (auto& point : points) point.z() -= radius;
  fit(points);
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Eigen::Vector3d> touched = points;
    for (std::size_t i = 0; i < points.size(); ++i)
      touched[i] = centres[i] - radius * normal(points[i].x(), points[i].y());
    points = touched;
    fit(points);
  }
}

void Surface::fit(const std::vector<Eigen::Vector3d>& points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd terms(count, (degree_x_ + 1) * (degree_y_ + 1));
  Eigen::VectorXd heights(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d& point = points[static_cast<std::size_t>(i)];
    const Eigen::Vector2d at = scaled(point.x(), point.y());
    const Eigen::MatrixXd products = values(at.x(), degree_x_) * values(at.y(), degree_y_).transpose();
    terms.row(i) = products.reshaped().transpose();
    heights[i] = point.z();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(terms);
  if (solver.rank() < terms.cols()) {
    throw mrroc::NonFatalError(mrroc::ErrorCode::invalid_argument,
                               "the touched points do not determine the surface, expected more columns or rows");
  }
  const Eigen::VectorXd solution = solver.solve(heights);
  rms_ = std::sqrt((terms * solution - heights).squaredNorm() / static_cast<double>(count));
  coefficients_ = solution.reshaped(degree_x_ + 1, degree_y_ + 1);
}

double Surface::height(double x, double y) const {
  const Eigen::Vector2d at = scaled(x, y);
  return values(at.x(), degree_x_).dot(coefficients_ * values(at.y(), degree_y_));
}

Eigen::Vector3d Surface::normal(double x, double y) const {
  const Eigen::Vector2d at = scaled(x, y);
  const Eigen::VectorXd s = values(at.x(), degree_x_), t = values(at.y(), degree_y_);
  const double along_x = slopes(at.x(), degree_x_).dot(coefficients_ * t) / half_.x();
  const double along_y = s.dot(coefficients_ * slopes(at.y(), degree_y_)) / half_.y();
  return Eigen::Vector3d(-along_x, -along_y, 1).normalized();
}

mrroc::Pose Surface::tool_at(const Eigen::Vector2d& xy, double depth) const {
  const Eigen::Vector3d up = normal(xy.x(), xy.y()), across = Eigen::Vector3d::UnitY().cross(up).normalized();
  mrroc::Pose pose = mrroc::Pose::Identity();
  pose.linear() << across, across.cross(up), -up;
  pose.translation() = Eigen::Vector3d(xy.x(), xy.y(), height(xy.x(), xy.y())) - depth * up;
  return pose;
}

Eigen::VectorXd Surface::values(double s, int degree) {
  Eigen::VectorXd t(degree + 1);
  for (int i = 0; i <= degree; ++i) t[i] = i == 0 ? 1 : i == 1 ? s : 2 * s * t[i - 1] - t[i - 2];
  return t;
}

Eigen::VectorXd Surface::slopes(double s, int degree) {
  const Eigen::VectorXd t = values(s, degree);
  Eigen::VectorXd d(degree + 1);
  for (int i = 0; i <= degree; ++i) d[i] = i == 0 ? 0 : i == 1 ? 1 : 2 * t[i - 1] + 2 * s * d[i - 1] - d[i - 2];
  return d;
}

}  // namespace engraving
