// Random faults in random order: the commands to the drives keep the limits, the robot does not move on its own, and
// every command gets an answer.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "edp/rig.hpp"
#include "edp/safety/stop_category.hpp"
#include "repetitions.hpp"

namespace mrroc::edp::safety_property_test {
namespace {

constexpr int kStopInput = 5;

class WatchedGantry : public Gantry {
 public:
  WatchedGantry() {
    for (AxisParameters& axis : parameters_.axes) {
      axis.jerk_max = 400;
      axis.current_max_time = 0.02;
    }
    for (const std::size_t i : {1u, 2u, 3u}) {  // stuck axes are detected by other means
      parameters_.axes[i].current_max_time = 1e9;
      parameters_.axes[i].following_error_max = 3;
      parameters_.axes[i].stuck_max = 1;
    }
  }
};

/// Statistics of all cases of the suite.
struct Totals {
  std::uint64_t ticks = 0, stopping_ticks = 0, commands = 0, recoveries = 0, emergencies = 0;
  std::map<ErrorCode, int> faults;
};

/// A robot under random events, checked in every tick.
class Driver {
 public:
  Driver(std::uint64_t seed, Totals& totals) : random_(seed), totals_(totals) {
    rig_.hardware.close(kStopInput);
    rig_.servo.use_emergency_terminal(kStopInput);
    rig_.hardware.spoil = [this](HardwareInput& input) { spoil(input); };
    rig_.run(1);
  }

  void run(Tick ticks) {
    while (rig_.now < ticks) {
      happen();
      send();
      tick();
    }
    finish();
    totals_.ticks += rig_.now;
  }

 private:
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance(double probability) { return real(0, 1) < probability; }
  JointVector vector(double magnitude) {
    JointVector values(4);
    for (double& value : values) value = real(-magnitude, magnitude);
    return values;
  }

  void spoil(HardwareInput& input) const {
    const auto k = static_cast<std::size_t>(axis_);
    if (not_finite_) input.motors[axis_] = std::numeric_limits<double>::quiet_NaN();
    if (jumped_) input.motors[axis_] += 50;
    if (overload_) input.current[axis_] = -20;
    if (on_lower_) input.switches[k].lower_limit = true;
    if (on_upper_) input.switches[k].upper_limit = true;
    input.inputs.set(kStopInput, !pressed_);
  }

  /// Faults come and go; the operator presses and resets the emergency stop.
  void happen() {
    if (!wrong() && chance(0.5)) axis_ = integer(0, 3);
    for (bool* fault : {&overload_, &on_lower_, &on_upper_, &pressed_, &rig_.hardware.positions_lost})
      if (chance(*fault ? 0.02 : 0.0003)) *fault = !*fault;
    if (chance(rig_.hardware.jam ? 0.005 : 0.0003)) {
      rig_.hardware.jam = !rig_.hardware.jam;
      rig_.hardware.stuck = chance(0.5);
    }
    // one at a time: a jump during another fault would be a real change of position
    ErrorCode& reported = rig_.hardware.fault;
    if (not_finite_ || jumped_ || reported != ErrorCode::none) {
      if (chance(0.02)) not_finite_ = jumped_ = false, reported = ErrorCode::none;
    } else if (chance(0.001)) {
      const double what = real(0, 1);
      not_finite_ = what < 0.25;
      jumped_ = what > 0.75;
      if (!not_finite_ && !jumped_) reported = what < 0.5 ? ErrorCode::drive_fault : ErrorCode::hardware_silent;
    }
    if (chance(0.0005)) {
      rig_.operators.press();
      latched_ = true;
      ++totals_.emergencies;
    } else if (chance(0.01)) {
      rig_.operators.reset();
      latched_ = latched_ && pressed_;
    }
    latched_ = latched_ || pressed_;
    if (chance(0.0003)) rig_.effector.enable(false);
    if (chance(0.0003)) {
      rig_.effector.enable(true);
      asked_ = true;
    }
  }
  bool wrong() const { return not_finite_ || jumped_ || overload_ || on_lower_ || on_upper_; }

  void send() {
    if (!waiting_.empty() && !chance(0.01)) return;
    if (!chance(0.3)) return;
    RobotCommand command;
    const int steps = integer(5, 150);
    command.motion_steps = static_cast<std::uint16_t>(steps);
    command.reply_step = static_cast<std::uint16_t>(std::max(1, steps - integer(0, 3)));
    command.relative = true;
    const double what = real(0, 1);
    const bool recovers = what < 0.1;
    command.kind = recovers      ? CommandKind::recover
                   : what < 0.15 ? CommandKind::query
                   : what < 0.2  ? CommandKind::hold
                   : what < 0.6  ? CommandKind::joint
                                 : CommandKind::joint_velocity;
    RobotState state;
    rig_.effector.peek(state);
    const double time = steps * kPeriod;
    command.joint_velocity =
        (0.9 * state.desired_velocity + vector(std::min(0.3, 3 * time))).cwiseMax(-0.7).cwiseMin(0.7);
    command.joints = 0.5 * time * (state.desired_velocity + command.joint_velocity);
    if (chance(0.05)) command.joints[0] = std::numeric_limits<double>::quiet_NaN();
    ++totals_.commands;
    if (rig_.send(command)) {
      RC_ASSERT(rig_.answer.command == rig_.number);
      return;
    }
    waiting_.insert(rig_.number);
    if (recovers)
      asked_ = true;
    else
      commanded_ = true;
  }

  void tick() {
    rig_.tick();
    check_drives();
    check_set_point();
    for (const Reply& reply : rig_.replies) RC_ASSERT(waiting_.erase(reply.command) == 1u);  // sent, not answered yet
    rig_.replies.clear();
    powered_ = rig_.hardware.powered;
    previous_ = rig_.seen().desired;
    fault_ = rig_.seen().fault.code;
  }

  /// Conditions for the drives to stay on or off.
  void check_drives() {
    const Snapshot& seen = rig_.seen();
    const bool on = rig_.hardware.powered;
    if (on && !powered_) {
      RC_ASSERT(asked_);  // neither a reset nor the end of a fault may switch them on
      RC_ASSERT(!latched_);
      commanded_ = false;
      began_ = seen.joints;
      ++totals_.recoveries;
      off_by_ = kNever;
      RC_ASSERT(seen.desired.position == seen.joints);
      RC_ASSERT(seen.desired.at_rest());
    }
    if (rig_.hand_over.order.load() == DriveOrder::none) asked_ = false;
    if (on) RC_ASSERT(!latched_ || !seen.enabled());
    if (seen.fault.code != ErrorCode::none && fault_ == ErrorCode::none) {
      ++totals_.faults[seen.fault.code];
      if (on && is_hindered(seen.fault.code)) stand_where_it_is(seen);
      Stop stop(rig_.model.parameters(), kPeriod);
      stop.plan(previous_);
      off_by_ = seen.tick + stop.ticks();
      if (stop_category(seen.fault.code) == StopCategory::drives_off) RC_ASSERT(!on);
    }
    if (seen.fault.code != ErrorCode::none) RC_ASSERT(!on || seen.tick < off_by_);
    if (on && seen.fault.code != ErrorCode::none) ++totals_.stopping_ticks;
  }

  /// A robot that does not follow its set-point stops from where it is: as if it had been a tick before it.
  void stand_where_it_is(const Snapshot& seen) {
    previous_ = DesiredState::resting_at(seen.joints);
    for (Eigen::Index i = 0; i < 4; ++i) {
      const double most = rig_.model.parameters().axes[static_cast<std::size_t>(i)].velocity_max;
      previous_.velocity[i] = std::clamp(seen.joint_velocity[i], -most, most);
    }
    previous_.position -= kPeriod * previous_.velocity;
  }

  /// The commands to the drives are within the limits, and continuous with the previous ones.
  void check_set_point() {
    if (!rig_.hardware.powered || !powered_) return;
    const DesiredState& now = rig_.seen().desired;
    if (!commanded_) RC_ASSERT(now.position == previous_.position);  // nothing moves on its own
    for (int i = 0; i < 4; ++i) {
      const AxisParameters& axis = rig_.model.parameters().axes[static_cast<std::size_t>(i)];
      const double way = now.position[i] - previous_.position[i];
      const double mean = 0.5 * (now.velocity[i] + previous_.velocity[i]);
      RC_ASSERT(now.position[i] >= std::min(axis.position_min, began_[i]) - 1e-8);
      RC_ASSERT(now.position[i] <= std::max(axis.position_max, began_[i]) + 1e-8);
      RC_ASSERT(std::abs(now.velocity[i]) <= axis.velocity_max * (1 + 1e-8));
      RC_ASSERT(std::abs(now.acceleration[i]) <= axis.acceleration_max * (1 + 1e-8));
      const double acceleration = (now.velocity[i] - previous_.velocity[i]) / kPeriod;
      const double jerk = (now.acceleration[i] - previous_.acceleration[i]) / kPeriod;
      RC_ASSERT(std::abs(acceleration) <= axis.acceleration_max * (1 + 1e-6));
      RC_ASSERT(std::abs(jerk) <= axis.jerk_max * (1 + 1e-3));
      RC_ASSERT(std::abs(way - mean * kPeriod) <= axis.jerk_max * kPeriod * kPeriod * kPeriod);
    }
  }

  /// In the end, without faults, the robot recovers and executes its commands; every command has had its answer.
  void finish() {
    not_finite_ = jumped_ = overload_ = on_lower_ = on_upper_ = pressed_ = false;
    rig_.hardware.jam = rig_.hardware.positions_lost = false;
    rig_.hardware.fault = ErrorCode::none;
    for (int i = 0; i < 2000; ++i) tick();
    rig_.operators.reset();
    latched_ = false;
    for (int i = 0; i < 60'000 && !waiting_.empty(); ++i) tick();
    RC_ASSERT(waiting_.empty());
    RobotCommand command;
    command.kind = CommandKind::recover;
    asked_ = true;
    RC_ASSERT(!rig_.send(command));
    waiting_.insert(rig_.number);
    for (int i = 0; i < 5; ++i) tick();
    RC_ASSERT(rig_.seen().fault.code == ErrorCode::none);
    RC_ASSERT(rig_.hardware.powered);
    command = joint_command(0.9 * rig_.seen().desired.position, 2000, 2000);
    RC_ASSERT(!rig_.send(command));
    waiting_.insert(rig_.number);
    commanded_ = true;
    for (int i = 0; i < 2100; ++i) tick();
    RC_ASSERT(rig_.seen().desired.position == command.joints);
    RC_ASSERT(waiting_.empty());
  }

  std::mt19937_64 random_;
  Totals& totals_;
  Rig<WatchedGantry> rig_{false};
  // present faults of `axis_`
  int axis_ = 0;
  bool not_finite_ = false, jumped_ = false, overload_ = false, on_lower_ = false, on_upper_ = false, pressed_ = false;
  bool latched_ = false;    ///< expected state of the emergency stop
  bool asked_ = false;      ///< the drives were requested on
  bool commanded_ = false;  ///< a motion was commanded since the drives are on
  Tick off_by_ = kNever;    ///< latest tick at which a fault must have switched the drives off
  std::set<std::uint64_t> waiting_;
  JointVector began_;  ///< position at which the drives were switched on
  // of the previous tick
  bool powered_ = false;
  DesiredState previous_;
  ErrorCode fault_ = ErrorCode::none;
};

TEST(Safety, RandomFaultsKeepTheLimitsCauseNoMotionAndEveryCommandHasOneAnswer) {
  Totals totals;
  EXPECT_TRUE(rc::check([&totals] {
    Driver driver(*rc::gen::arbitrary<std::uint64_t>(), totals);
    driver.run(12'000);
  }));
  std::cout << totals.ticks << " ticks, " << totals.stopping_ticks << " of them in stops of category 1, "
            << totals.commands << " commands, switched on " << totals.recoveries << " times, " << totals.emergencies
            << " presses; faults:";
  for (const auto& [code, count] : totals.faults) std::cout << " " << count << " " << describe(code) << ";";
  std::cout << "\n";
  for (const ErrorCode code :
       {ErrorCode::drive_fault, ErrorCode::hardware_silent, ErrorCode::encoder_fault, ErrorCode::following_error,
        ErrorCode::axis_stuck, ErrorCode::over_current, ErrorCode::limit_switch, ErrorCode::emergency_stop})
    EXPECT_GT(totals.faults[code], test::repetitions(5)) << describe(code);
  EXPECT_GE(totals.ticks, test::repetitions(1'000'000u));
  EXPECT_GT(totals.stopping_ticks, test::repetitions(500u));
}

}  // namespace
}  // namespace mrroc::edp::safety_property_test
