#include <cmath>

#include "core/require.hpp"
#include "core/short_number.hpp"
#include "mrroc/conditions/digital_input.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/operator_trigger.hpp"
#include "mrroc/conditions/touching.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

Travelled::Travelled(const Robot& robot, double distance)
    : Condition("travelled " + short_number(distance) + " m"), robot_(&robot), distance_(distance) {
  require_above_zero("Travelled", "distance", distance);
}

void Travelled::start() { origin_ = robot_->state().pose.translation(); }

bool Travelled::holds() { return (robot_->state().pose.translation() - origin_).norm() >= distance_; }

Touching::Touching(const Robot& robot, double newtons)
    : Condition(robot.name() + " feels " + short_number(newtons) + " N"), robot_(&robot), newtons_(newtons) {
  require_above_zero("Touching", "force", newtons);
}

DigitalInput::DigitalInput(const Robot& robot, int terminal)
    : Condition(robot.name() + " input " + std::to_string(terminal)), robot_(&robot), terminal_(terminal) {
  if (terminal < 0 || terminal >= ControllerIo::kDigital) {
    throw NonFatalError(ErrorCode::invalid_argument, "DigitalInput " + std::to_string(terminal) + ", expected 0 to " +
                                                         std::to_string(ControllerIo::kDigital - 1));
  }
}

ElapsedSteps::ElapsedSteps(std::uint64_t steps)
    : Condition("elapsed " + std::to_string(steps) + " steps"), steps_(steps) {}

OperatorTrigger::OperatorTrigger(Task& task) : Condition("operator trigger"), task_(&task) {}

void OperatorTrigger::start() {
  given_ = false;
  while (task_->take_trigger()) {
  }
}

bool OperatorTrigger::holds() {
  given_ = given_ || task_->take_trigger();
  return given_;
}

}  // namespace mrroc
