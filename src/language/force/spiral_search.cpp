#include "mrroc/generators/spiral_search.hpp"

#include <cmath>
#include <numbers>

#include "core/require.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

SpiralSearch::SpiralSearch(Robot& robot, const ForceLaw& law, double pitch, double radius, double speed)
    : Generator("SpiralSearch"), robot_(&robot), law_(law), pitch_(pitch), radius_(radius), speed_(speed) {
  require_above_zero("SpiralSearch", "pitch", pitch);
  require_above_zero("SpiralSearch", "radius", radius);
  require_above_zero("SpiralSearch", "speed", speed);
}

Eigen::Vector2d SpiralSearch::spiral(double angle) const noexcept {
  return pitch_ * angle / (2 * std::numbers::pi) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

void SpiralSearch::next_state() {
  const double duration = robot_->step_duration(), speed = robot_->task().operator_speed() * speed_;
  const Eigen::Vector2d before = spiral(angle_);
  const double growth = pitch_ / (2 * std::numbers::pi);
  // the angle's rate at the middle of the macrostep (Runge and Kutta, second order)
  const auto rate = [&](double angle) { return speed / (growth * std::hypot(angle, 1.0)); };
  angle_ += duration * rate(angle_ + 0.5 * duration * rate(angle_));
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::force;
  command.twist.head<2>() = (spiral(angle_) - before) / duration;
  command.force = law_;
}

}  // namespace mrroc
