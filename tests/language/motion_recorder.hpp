#pragma once

#include "mrroc/step_observer.hpp"

namespace mrroc::fakes {

/// Records the first robot's state and command of every step with a command.
class MotionRecorder : public StepObserver {
 public:
  void on_step(const StepRecord& record) noexcept override {
    if (record.last()) return;
    states.push_back(record.states[0]);
    commands.push_back(record.commands[0]);
  }
  std::vector<RobotState> states;
  std::vector<RobotCommand> commands;
};

}  // namespace mrroc::fakes
