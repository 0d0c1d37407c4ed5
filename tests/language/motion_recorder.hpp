#pragma once

#include "mrroc/step_observer.hpp"

namespace mrroc::fakes {

/// Keeps the first robot's state and command of every step that commands.
class MotionRecorder : public StepObserver {
 public:
  void on_step(const StepRecord& record) noexcept override {
    if (record.last) return;
    states.push_back(record.robots[0]->state());
    commands.push_back(record.robots[0]->command());
  }
  std::vector<RobotState> states;
  std::vector<RobotCommand> commands;
};

}  // namespace mrroc::fakes
