#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <random>

#include "repetitions.hpp"
#include "rig.hpp"

namespace mrroc::edp::property_test {
namespace {

/// A gantry with a jerk limit that random commands reach.
class SmoothGantry : public Gantry {
 public:
  SmoothGantry() {
    for (AxisParameters& axis : parameters_.axes) axis.jerk_max = 400;
  }
};

/// Statistics of all cases of the suite, printed at the end.
struct Totals {
  std::uint64_t ticks = 0, accepted = 0, refused = 0, late = 0, stretched = 0, stops = 0, aborted = 0;
};

/// A robot under random commands at random times, checked in every tick.
class Driver {
 public:
  Driver(std::uint64_t seed, Totals& totals) : random_(seed), totals_(totals) {
    for (AxisParameters& axis : rig_.model.change().axes) axis.following_error_max = 1e9;
    previous_ = rig_.seen().desired;
  }

  void run(Tick ticks) {
    while (rig_.now < ticks) {
      maybe_switch();
      maybe_send();
      rig_.tick();
      check_set_point();
      check_replies();
    }
    RC_ASSERT(rig_.seen().fault.code == ErrorCode::none);
    if (!switched_off_) finish();
    totals_.ticks += rig_.now;
    totals_.accepted += rig_.effector.counters().accepted;
    totals_.refused += rig_.effector.counters().refused;
    totals_.late += rig_.effector.counters().late;
    totals_.stretched += rig_.effector.counters().stretched;
    totals_.stops += rig_.seen().counters.stops;
  }

 private:
  /// The time of the reply to an accepted command: exactly `tick`, or not before it when the duration was stretched.
  struct Expected {
    Tick tick;
    bool exact;
  };

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance(double probability) { return real(0, 1) < probability; }
  JointVector vector(double magnitude) {
    JointVector values(4);
    for (double& value : values) value = real(-magnitude, magnitude);
    return values;
  }

  void maybe_switch() {
    if (chance(0.0005)) {
      switched_off_ = true;
      rig_.effector.enable(false);
    } else if (switched_off_ && chance(0.01)) {
      switched_off_ = false;
      rig_.effector.enable(true);
      previous_enabled_ = false;
    }
  }

  /// Mostly one command per reply, in time or late; occasionally a second or third without waiting.
  void maybe_send() {
    if (!expected_.empty() && !chance(0.005)) return;
    if (expected_.empty() && pause_ > 0) {
      --pause_;
      return;
    }
    pause_ = chance(0.8) ? 0 : integer(1, 60);
    const RobotCommand command = random_command();
    RobotState before;
    rig_.effector.peek(before);
    const auto stretched_before = rig_.effector.counters().stretched;
    if (rig_.send(command)) {
      RC_ASSERT(rig_.answer.command == rig_.number);
      RC_ASSERT((command.kind == CommandKind::query || rig_.answer.state.error.error_class != ErrorClass::none));
      RC_ASSERT((rig_.answer.state.error.error_class == ErrorClass::none || !rig_.answer.state.error.detail.empty()));
      return;
    }
    RC_ASSERT(command.kind != CommandKind::query);
    const bool moving_end = !(before.desired_velocity.isZero(0) && before.desired_acceleration.isZero(0));
    const bool stops_first = moving_end && command.start_tick > before.desired_tick;
    const bool longer = rig_.effector.counters().stretched > stretched_before || command.kind == CommandKind::hold;
    const Tick start = std::max(before.desired_tick, command.start_tick);
    const bool exact = !stops_first && !(longer && command.reply_step > command.motion_steps);
    expected_[rig_.number] = {start + command.reply_step, exact};
  }

  RobotCommand random_command() {
    RobotState state;
    rig_.effector.peek(state);
    RobotCommand command;
    const int steps = chance(0.1) ? integer(1, 5) : integer(5, 150);
    command.motion_steps = static_cast<std::uint16_t>(steps);
    command.reply_step = static_cast<std::uint16_t>(chance(0.1) ? steps + 1 : std::max(1, steps - integer(0, 3)));
    if (chance(0.1)) command.start_tick = rig_.now + static_cast<Tick>(integer(0, 300));
    const double what = real(0, 1);
    if (what < 0.02) return command;  // a query
    command.kind = what < 0.07   ? CommandKind::hold
                   : what < 0.35 ? CommandKind::joint
                   : what < 0.6  ? CommandKind::pose
                   : what < 0.75 ? CommandKind::motor
                   : what < 0.9  ? CommandKind::joint_velocity
                                 : CommandKind::twist;
    command.interpolation = static_cast<Interpolation>(integer(0, 2));
    command.relative = chance(0.5);

    // a velocity that can be reached, and a path on which it is reached smoothly
    const double time = steps * kPeriod;
    const JointVector velocity =
        chance(0.2)
            ? JointVector(JointVector::Zero(4))
            : JointVector(
                  (0.9 * state.desired_velocity + vector(std::min(0.3, 3 * time))).cwiseMax(-0.7).cwiseMin(0.7));
    JointVector increment = 0.5 * time * (state.desired_velocity + velocity);
    if (chance(0.1)) increment += vector(0.1);
    command.joint_velocity = velocity;
    if (chance(0.3)) command.joint_acceleration = vector(1);
    command.joints = command.relative ? increment : JointVector(state.desired_joints + increment);
    if (command.kind == CommandKind::motor) {
      command.joints *= GearedModel::kGear;
      command.joint_velocity *= GearedModel::kGear;
      command.joint_acceleration *= GearedModel::kGear;
    }
    if (command.kind == CommandKind::twist) command.relative = false;
    if (command.kind == CommandKind::pose || command.kind == CommandKind::twist) {
      const Pose target = rig_.model.flange(state.desired_joints + increment);
      command.pose = command.relative ? Pose(rig_.model.flange(state.desired_joints).inverse() * target) : target;
      command.twist << velocity.head<3>(), 0, 0, velocity[3];
    }
    if (chance(0.1)) spoil(command);
    return command;
  }

  void spoil(RobotCommand& command) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    switch (integer(0, 9)) {
      case 0:
        command.joints[integer(0, 3)] = kNan;
        command.pose.translation().x() = kNan;
        break;
      case 1:
        command.joint_velocity[0] = std::numeric_limits<double>::infinity();
        command.twist[5] = kNan;
        break;
      case 2:
        command.joints = vector(1).head(3);
        break;
      case 3:
        command.motion_steps = 0;
        break;
      case 4:
        command.reply_step = static_cast<std::uint16_t>(command.motion_steps + 2);
        break;
      case 5:
        command.reply_step = 0;
        break;
      case 6:
        command.kind = static_cast<CommandKind>(integer(static_cast<int>(CommandKind::set_outputs) + 1, 255));
        break;
      case 7:
        command.start_tick = random_();
        break;
      case 8:
        command.joints = vector(1e300);
        command.twist *= 1e200;
        break;
      default:
        command.pose.linear() *= real(-2, 2);
        command.joints = vector(10);
        command.joint_velocity = vector(3);
    }
  }

  void check_set_point() {
    const Snapshot& seen = rig_.seen();
    const DesiredState& now = seen.desired;
    if (!rig_.hardware.powered || !previous_enabled_) {  // follows the measured position, or has just been switched on
      previous_enabled_ = rig_.hardware.powered;
      previous_ = now;
      return;
    }
    for (int i = 0; i < 4; ++i) {
      const AxisParameters& axis = rig_.model.parameters().axes[static_cast<std::size_t>(i)];
      const double way = now.position[i] - previous_.position[i];
      const double mean = 0.5 * (now.velocity[i] + previous_.velocity[i]);
      RC_ASSERT(now.position[i] >= axis.position_min - 1e-8);
      RC_ASSERT(now.position[i] <= axis.position_max + 1e-8);
      RC_ASSERT(std::abs(now.velocity[i]) <= axis.velocity_max * (1 + 1e-8));
      RC_ASSERT(std::abs(way) <= axis.velocity_max * kPeriod * (1 + 1e-8));
      RC_ASSERT(std::abs(now.acceleration[i]) <= axis.acceleration_max * (1 + 1e-8));
      // neither velocity nor acceleration jumps, and the position follows the velocity
      const double acceleration = (now.velocity[i] - previous_.velocity[i]) / kPeriod;
      const double jerk = (now.acceleration[i] - previous_.acceleration[i]) / kPeriod;
      RC_ASSERT(std::abs(acceleration) <= axis.acceleration_max * (1 + 1e-6));
      RC_ASSERT(std::abs(jerk) <= axis.jerk_max * (1 + 1e-3));
      RC_ASSERT(std::abs(way - mean * kPeriod) <= axis.jerk_max * kPeriod * kPeriod * kPeriod);
    }
    previous_ = now;
  }

  void check_replies() {
    for (const Reply& reply : rig_.replies) {
      const auto found = expected_.find(reply.command);
      RC_ASSERT(found != expected_.end());  // neither unknown nor answered before
      if (reply.state.error.error_class != ErrorClass::none) {
        RC_ASSERT(reply.state.error.code == ErrorCode::not_enabled);
        ++totals_.aborted;
      } else if (found->second.exact) {
        RC_ASSERT(reply.state.tick == found->second.tick);
      } else {
        RC_ASSERT(reply.state.tick >= found->second.tick);
      }
      RC_ASSERT(reply.state.tick == rig_.seen().tick);
      expected_.erase(found);
    }
    rig_.replies.clear();
  }

  /// No command is lost: all get their reply.
  void finish() {
    for (int i = 0; i < 60000 && !expected_.empty(); ++i) {
      rig_.tick();
      check_set_point();
      check_replies();
    }
    RC_ASSERT(expected_.empty());
  }

  std::mt19937_64 random_;
  Totals& totals_;
  Rig<SmoothGantry> rig_;
  DesiredState previous_;
  bool previous_enabled_ = false;
  bool switched_off_ = false;
  int pause_ = 0;
  std::map<std::uint64_t, Expected> expected_;
};

TEST(Edp, UnderRandomCommandsTheLimitsHoldAtEveryTickAndEveryCommandGetsOneReplyInTime) {
  Totals totals;
  EXPECT_TRUE(rc::check([&totals] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    Driver driver(seed, totals);
    driver.run(12'000);
  }));
  std::cout << totals.ticks << " ticks, " << totals.accepted << " commands accepted, " << totals.refused << " refused, "
            << totals.late << " late, " << totals.stretched << " stretched, " << totals.stops << " brakings, "
            << totals.aborted << " aborted\n";
  EXPECT_GE(totals.ticks, test::repetitions(1'000'000u));
  EXPECT_GT(totals.accepted, test::repetitions(5'000u));
  EXPECT_GT(totals.late, test::repetitions(100u));
  EXPECT_GT(totals.stretched, test::repetitions(10u));
  EXPECT_GT(totals.refused, test::repetitions(1'000u));
  EXPECT_GT(totals.aborted, test::repetitions(10u));
}

}  // namespace
}  // namespace mrroc::edp::property_test
