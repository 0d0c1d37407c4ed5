#pragma once

#include <algorithm>
#include <cmath>
#include <mrroc/generator.hpp>
#include <mrroc/robot.hpp>
#include <numbers>

/// The first axis goes there and back in `duration` s: q(t) = q(0) + angle sin^4(pi t / duration), at rest at both
/// ends.
class ToAndFro : public mrroc::Generator {
 public:
  ToAndFro(mrroc::Robot& robot, double angle, double duration)
      : Generator("ToAndFro"), robot_(robot), angle_(angle), duration_(duration) {}

  void start() override {
    from_ = robot_.state().desired_joints;
    time_ = 0;
  }

  bool terminal_condition() override { return time_ >= duration_; }

  void next_state() override {
    time_ = std::min(time_ + robot_.step_duration(), duration_);
    const double w = std::numbers::pi / duration_, s = std::sin(w * time_), c = std::cos(w * time_);
    mrroc::RobotCommand& command = robot_.command();
    command.kind = mrroc::CommandKind::joint;
    command.joints = from_;
    command.joints[0] += angle_ * s * s * s * s;
    command.joint_velocity = mrroc::JointVector::Zero(from_.size());
    command.joint_velocity[0] = 4 * angle_ * w * s * s * s * c;
    command.joint_acceleration = mrroc::JointVector::Zero(from_.size());
    command.joint_acceleration[0] = 4 * angle_ * w * w * s * s * (3 * c * c - s * s);
  }

 private:
  mrroc::Robot& robot_;
  double angle_;     // rad
  double duration_;  // s
  double time_ = 0;  // s, at the end of the macrostep
  mrroc::JointVector from_;
};
