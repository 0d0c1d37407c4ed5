#pragma once

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// A digital input of the robot's controller is on; `!DigitalInput{arm, 3}` for off.
class DigitalInput : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `terminal` is 0..15.
  DigitalInput(const Robot& robot, int terminal);

 protected:
  bool holds() override { return robot_->state().inputs.on(terminal_); }

 private:
  const Robot* robot_;
  int terminal_;
};

}  // namespace mrroc
