#pragma once

#include <mrroc/generator.hpp>
#include <mrroc/robot.hpp>
#include <mrroc/tracker.hpp>

/// The first axis goes to `angle` rad from where it is, and back, at a part `speed` of its limits.
class ToAndFro : public mrroc::Generator {
 public:
  ToAndFro(mrroc::Robot& robot, double angle, double speed)
      : Generator("ToAndFro"), robot_(robot), tracker_(robot, speed), angle_(angle) {}

  void start() override {
    there_ = back_ = robot_.state().desired_joints;
    there_[0] += angle_;
    returns_ = false;
  }

  bool terminal_condition() override { return returns_ && tracker_.arrived(); }

  void next_state() override {
    returns_ = returns_ || tracker_.arrived();
    tracker_.to(returns_ ? back_ : there_);
  }

 private:
  mrroc::Robot& robot_;
  mrroc::Tracker tracker_;
  double angle_;  // rad
  bool returns_ = false;
  mrroc::JointVector there_, back_;
};
