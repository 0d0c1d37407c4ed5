#include "language/servoing/visual_servo.hpp"

#include <algorithm>
#include <cmath>

#include "core/require.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

VisualServo::VisualServo(Robot& robot, const ServoLimits& limits, const char* name)
    : robot_(&robot), limits_(limits), name_(name), follower_(robot, limits.acceleration) {
  require_above_zero(name, "gain", limits.gain);
  require_above_zero(name, "speed", limits.speed);
  require_above_zero(name, "angular speed", limits.angular_speed);
  require_not_negative(name, "patience", limits.patience);
}

void VisualServo::start() {
  follower_.start();
  lost_ = 0;
}

void VisualServo::step(const std::optional<Twist>& wanted) {
  if (!wanted) {
    if (++lost_ > limits_.patience) {
      throw NonFatalError(
          ErrorCode::sensor_not_ready,
          std::string(name_) + ": the target is lost for " + std::to_string(limits_.patience) + " steps",
          {robot_->task().process_name(), robot_->name(), 0, robot_->state().tick});
    }
    return follower_.step(Twist::Zero());
  }
  lost_ = 0;
  const double excess =
      std::max({1.0, wanted->head<3>().norm() / limits_.speed, wanted->tail<3>().norm() / limits_.angular_speed});
  follower_.step(*wanted / excess);
}

}  // namespace mrroc
