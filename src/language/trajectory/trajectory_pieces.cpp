#include "language/trajectory/trajectory_pieces.hpp"

namespace mrroc {

using Order = JointTrajectory::Order;

void TrajectoryPieces::begin(const JointTrajectory& trajectory, const DesiredState& from) noexcept {
  trajectory_ = &trajectory;
  from_ = from;
}

std::size_t TrajectoryPieces::piece_at(double time) const noexcept {
  std::size_t low = first(), high = trajectory_->points();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (trajectory_->time(middle) < time)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

double TrajectoryPieces::position_before(std::size_t piece, std::size_t axis) const noexcept {
  return piece == 0 ? from_.position[static_cast<Eigen::Index>(axis)] : trajectory_->position(piece - 1, axis);
}

double TrajectoryPieces::slope(std::size_t piece, std::size_t axis) const noexcept {
  return (trajectory_->position(piece, axis) - position_before(piece, axis)) /
         (trajectory_->time(piece) - time_before(piece));
}

double TrajectoryPieces::velocity(std::size_t point, std::size_t axis) const noexcept {
  if (trajectory_->order() != Order::positions) return trajectory_->velocity(point, axis);
  if (point + 1 == trajectory_->points() || point < first()) return 0;
  const double before = slope(point, axis), after = slope(point + 1, axis);
  if (before * after <= 0) return 0;
  const double h0 = trajectory_->time(point) - time_before(point);
  const double h1 = trajectory_->time(point + 1) - trajectory_->time(point);
  return 3 * (h0 + h1) / ((2 * h1 + h0) / before + (h1 + 2 * h0) / after);
}

AxisMotion TrajectoryPieces::at(std::size_t piece, std::size_t axis, double time) const noexcept {
  const JointTrajectory& points = *trajectory_;
  if (piece >= points.points()) return {points.position(points.points() - 1, axis), 0, 0};
  const auto index = static_cast<Eigen::Index>(axis);
  const double d = points.time(piece) - time_before(piece), s = (time - time_before(piece)) / d;
  const bool quintic = points.order() == Order::accelerations;
  const double p0 = position_before(piece, axis);
  const double v0 = d * (piece == 0 ? from_.velocity[index] : velocity(piece - 1, axis));
  const double p = points.position(piece, axis) - p0 - v0, v = d * velocity(piece, axis) - v0;
  double c2 = 3 * p - v, c3 = v - 2 * p, c4 = 0, c5 = 0;
  if (quintic) {
    c2 = d * d * (piece == 0 ? from_.acceleration[index] : points.acceleration(piece - 1, axis)) / 2;
    const double q = p - c2, w = v - 2 * c2, b = d * d * points.acceleration(piece, axis) - 2 * c2;
    c3 = 10 * q - 4 * w + b / 2;
    c4 = -15 * q + 7 * w - b;
    c5 = 6 * q - 3 * w + b / 2;
  }
  return {p0 + s * (v0 + s * (c2 + s * (c3 + s * (c4 + s * c5)))),
          (v0 + s * (2 * c2 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / d,
          (2 * c2 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / (d * d)};
}

}  // namespace mrroc
