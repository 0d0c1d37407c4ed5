// Limits at every tick while force motions, other motions, errors of the sensor and changes of the force come at
// random.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <iostream>
#include <random>

#include "force_rig.hpp"
#include "repetitions.hpp"

namespace mrroc::edp::force_property_test {
namespace {

constexpr double kRounding = 1e-6;

class SmoothGantry : public Gantry {
 public:
  SmoothGantry() {
    for (AxisParameters& axis : parameters_.axes) {
      axis.jerk_max = 400;
      axis.following_error_max = 1e9;
    }
  }
};

/// Statistics of all cases of the suite.
struct Totals {
  std::uint64_t ticks = 0, forced = 0, interrupted = 0, replies = 0;
};

class Driver {
 public:
  Driver(std::uint64_t seed, Totals& totals)
      : random_(seed), totals_(totals), rig_((ForceLimits() << 40, 40, 60, 5, 5, 5).finished()) {
    previous_ = rig_.seen().desired;
    rig_.sensor.stiffness = real(100, 20'000);
    rig_.sensor.wall = real(-1, 1);
  }

  void run(Tick ticks) {
    while (rig_.now < ticks) {
      disturb();
      if (waiting_ == 0 || chance(0.01)) send();
      rig_.tick();
      check();
      waiting_ -= rig_.replies.size();
      totals_.replies += rig_.replies.size();
      rig_.replies.clear();
    }
    RC_ASSERT(rig_.seen().fault.code == ErrorCode::none);
    rig_.run(5000);
    RC_ASSERT(rig_.replies.size() == waiting_);  // every command has its answer
    RC_ASSERT(rig_.seen().desired.at_rest());
    totals_.ticks += ticks;
    totals_.interrupted += rig_.seen().interruptions;
  }

 private:
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool chance(double probability) { return real(0, 1) < probability; }

  void disturb() {
    if (chance(0.01))
      for (double& value : rig_.sensor.extra) value = chance(0.5) ? 0 : real(-5, 5);
    if (chance(0.0005)) rig_.sensor.error = static_cast<ErrorCode>(integer(12, 13));
    if (chance(0.02)) rig_.sensor.error = ErrorCode::none;
  }

  void send() {
    const int left = chance(0.05) ? integer(0, 40) : 0;  // occasionally late
    for (int i = 0; i < left; ++i) {
      rig_.tick();
      check();
    }
    waiting_ -= rig_.replies.size();
    rig_.replies.clear();
    if (!rig_.send(any_command())) ++waiting_;
  }

  RobotCommand any_command() {
    RobotCommand command;
    command.motion_steps = static_cast<std::uint16_t>(integer(1, 40));
    command.reply_step = static_cast<std::uint16_t>(integer(1, command.motion_steps + 1));
    command.kind = chance(0.75) ? CommandKind::force : static_cast<CommandKind>(integer(1, 6));
    for (int i = 0; i < 6; ++i) {
      command.force.behaviour[static_cast<std::size_t>(i)] = static_cast<AxisBehaviour>(integer(0, 2));
      command.force.wrench[i] = real(-30, 30);
      command.force.admittance[i] = std::pow(10, real(-4, 0));
      command.force.inertia[i] = chance(0.2) ? 0 : real(0, 30);
    }
    const double speed = chance(0.1) ? 5 : 0.3;
    for (double& value : command.twist) value = real(-speed, speed);
    command.joints = command.joint_velocity = JointVector::Zero(4);
    command.relative = true;
    for (double& value : command.joints) value = real(-0.01, 0.01);
    command.joint_velocity.resize(command.kind == CommandKind::joint_velocity ? 4 : 0);
    for (double& value : command.joint_velocity) value = real(-0.5, 0.5);
    return command;
  }

  /// Position, velocity, acceleration and jerk of the set-point and of its change since the tick before.
  void check() {
    const DesiredState& now = rig_.seen().desired;
    const auto& axes = rig_.model.parameters().axes;
    for (int i = 0; i < 4; ++i) {
      const AxisParameters& axis = axes[static_cast<std::size_t>(i)];
      RC_ASSERT(now.position[i] >= axis.position_min - kRounding);
      RC_ASSERT(now.position[i] <= axis.position_max + kRounding);
      RC_ASSERT(std::abs(now.velocity[i]) <= axis.velocity_max * (1 + kRounding));
      RC_ASSERT(std::abs(now.acceleration[i]) <= axis.acceleration_max * (1 + kRounding));
      RC_ASSERT(std::abs(now.position[i] - previous_.position[i]) <= axis.velocity_max * kPeriod * (1 + kRounding));
      RC_ASSERT(std::abs(now.velocity[i] - previous_.velocity[i]) <= axis.acceleration_max * kPeriod * (1 + kRounding));
      RC_ASSERT(std::abs(now.acceleration[i] - previous_.acceleration[i]) <= axis.jerk_max * kPeriod * (1 + 1e-4));
    }
    if (!now.at_rest()) ++totals_.forced;
    previous_ = now;
  }

  std::mt19937_64 random_;
  Totals& totals_;
  ForceRig<SmoothGantry> rig_;
  DesiredState previous_;
  std::size_t waiting_ = 0;
};

TEST(ForceProperty, EveryTickKeepsTheLimitsUnderAnyForce) {
  Totals totals;
  EXPECT_TRUE(rc::check([&totals] {
    const auto seed = static_cast<std::uint64_t>(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1 << 30)));
    Driver(seed, totals).run(4000);
  }));
  std::cout << totals.ticks << " ticks, " << totals.forced << " in motion, " << totals.replies << " replies, "
            << totals.interrupted << " interruptions\n";
  EXPECT_GT(totals.interrupted, test::repetitions(100u));
  EXPECT_GT(totals.forced, totals.ticks / 4);
}

}  // namespace
}  // namespace mrroc::edp::force_property_test
