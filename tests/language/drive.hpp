#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "language/fakes.hpp"
#include "mrroc/generator.hpp"

namespace mrroc::fakes {

/// Commands `velocity` at the end of every macrostep to its robots, and runs `act` at the first step.
class Drive : public Generator {
 public:
  explicit Drive(std::vector<Robot*> robots, double velocity = 0.1)
      : Generator("drive"), robots_(std::move(robots)), velocity_(velocity) {}
  void next_state() override {
    if (act) act();
    for (Robot* robot : robots_) {
      robot->command().kind = CommandKind::joint;
      robot->command().joints = robot->state().desired_joints;
      robot->command().joint_velocity = JointVector::Constant(robot->state().joints.size(), velocity_);
    }
  }
  std::function<void()> act;

 private:
  std::vector<Robot*> robots_;
  double velocity_;
};

}  // namespace mrroc::fakes
