#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "edp/command/operator_motion.hpp"
#include "edp/rig.hpp"

namespace mrroc::edp {

inline constexpr Tick kValid = 100;  // ticks of a jog
inline constexpr double kLimitTolerance = 1e-6;

/// A gantry under the operator's orders; every set-point is compared with the limits.
class Operated : public Rig<Gantry> {
 public:
  explicit Operated(bool synchronised = true) : Rig(true, synchronised) {
    Rig::run(5);
    previous_ = seen().desired;
  }

  void tick() {
    servo.tick(now);
    Reply reply;
    while (effector.poll(reply)) {
      if (!OperatorMotion::is_own(reply.command))
        replies.push_back(reply);
      else if (motion.take(reply))
        answers.push_back(reply);
    }
    if (motion.update(seen().tick, reply)) answers.push_back(reply);
    if (motion.hold_for_late_motion(reply)) replies.push_back(reply);
    if (motion.poll_hold(seen().tick, reply)) replies.push_back(reply);
    ++now;
    check_limits();
  }
  void run(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) tick();
  }
  /// An order at the present tick; an answer that comes at once is appended to `answers`.
  std::uint64_t give(const RobotCommand& command) {
    Reply reply;
    if (motion.accept(command, ++orders, seen().tick, reply)) answers.push_back(reply);
    return orders;
  }
  void task_command(const RobotCommand& command) {
    if (motion.accept_of_task(command, number + 1, seen().tick))
      ++number;
    else if (send(command))
      replies.push_back(answer);
  }
  ErrorCode last_error() const { return answers.empty() ? ErrorCode::none : answers.back().state.error.code; }
  const JointVector& position() const { return seen().desired.position; }
  const JointVector& velocity() const { return seen().desired.velocity; }
  bool at_rest() const { return seen().desired.at_rest(); }

  OperatorMotion motion{effector, models, kPeriod};
  std::vector<Reply> answers;
  std::uint64_t orders = 0;

 private:
  void check_limits() {
    const DesiredState& desired = seen().desired;
    if (seen().enabled() && seen().synchronised) {
      for (Eigen::Index i = 0; i < desired.position.size(); ++i) {
        const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
        EXPECT_LE(desired.position[i], axis.position_max + kLimitTolerance) << seen().tick;
        EXPECT_GE(desired.position[i], axis.position_min - kLimitTolerance) << seen().tick;
        EXPECT_LE(std::abs(desired.velocity[i]), axis.velocity_max + kLimitTolerance) << seen().tick;
        EXPECT_LE(std::abs(desired.acceleration[i]), axis.acceleration_max + kLimitTolerance) << seen().tick;
        EXPECT_LE(std::abs(desired.acceleration[i] - previous_.acceleration[i]),
                  axis.jerk_max * kPeriod + kLimitTolerance);
      }
    }
    previous_ = desired;
  }

  DesiredState previous_;
};

inline JointVector axis(int index, double value) {
  JointVector values = JointVector::Zero(4);
  values[index] = value;
  return values;
}

inline RobotCommand jog(int index, double velocity) {
  RobotCommand command;
  command.kind = CommandKind::joint_velocity;
  command.joint_velocity = axis(index, velocity);
  return command;
}

inline RobotCommand order(CommandKind kind) {
  RobotCommand command;
  command.kind = kind;
  return command;
}

inline RobotCommand go(const JointVector& joints, bool relative = false) {
  RobotCommand command = order(CommandKind::joint);
  command.joints = joints;
  command.relative = relative;
  return command;
}

}  // namespace mrroc::edp
