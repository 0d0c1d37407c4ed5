#include "edp/servo/synchroniser.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "edp/check/switched_gantry.hpp"
#include "edp/random_values.hpp"
#include "edp/rig.hpp"

namespace mrroc::edp::synchroniser_test {
namespace {

constexpr double kIncrement = 2 * std::numbers::pi / 4000;

/// Starts at the position of the case; `home` is the position of the simulated robot.
class Placed : public Switched {
 public:
  Placed() { parameters_.home = where(); }
  static JointVector& where() {
    static JointVector home = JointVector::Zero(4);
    return home;
  }
};

RobotCommand command_of(CommandKind kind) {
  RobotCommand command;
  command.kind = kind;
  return command;
}

/// Synchronises from `where`, with the switches of `rewire`, and checks every set-point, the positions found and the
/// first motion after it.
void check_from(const JointVector& where, const std::function<void(FaultyHardware&)>& rewire = {}) {
  Placed::where() = where;
  Rig<Placed> rig(true, false);
  if (rewire) rewire(rig.hardware);
  RC_ASSERT(!rig.seen().synchronised);
  RC_ASSERT(rig.seen().joints.isZero(0));  // it counts from its position at power-on
  RC_ASSERT(!rig.send(command_of(CommandKind::synchronise)));
  DesiredState previous = rig.seen().desired;
  const auto& limits = rig.models.at(ModelSet::kShafts).parameters().axes;
  int moving = 0;
  while (rig.replies.empty() && rig.now < 200'000) {
    rig.tick();
    const DesiredState& desired = rig.seen().desired;
    if (rig.seen().synchronised) break;
    int axes = 0;
    for (int i = 0; i < 4; ++i) {
      const AxisParameters& axis = limits[static_cast<std::size_t>(i)];
      axes += desired.velocity[i] != 0;
      RC_ASSERT(std::abs(desired.velocity[i]) <= 15 * (1 + 1e-9));
      RC_ASSERT(std::abs(desired.acceleration[i]) <= axis.acceleration_max * (1 + 1e-9));
      RC_ASSERT(std::abs(desired.acceleration[i] - previous.acceleration[i]) <= axis.jerk_max * kPeriod * (1 + 1e-6));
      const double way = desired.position[i] - previous.position[i];
      RC_ASSERT(std::abs(way - 0.5 * kPeriod * (desired.velocity[i] + previous.velocity[i])) < 1e-3);
    }
    RC_ASSERT(axes <= 1);  // one after the other
    moving += axes;
    previous = desired;
  }
  RC_ASSERT(moving > 0);
  RC_ASSERT(rig.replies.size() == 1u);
  RC_ASSERT(rig.replies[0].state.error.error_class == ErrorClass::none);
  RC_ASSERT(rig.replies[0].state.synchronised);
  rig.run(200);
  // the true shafts, which only the plant has
  for (int i = 0; i < 4; ++i) {
    const double home = GearedModel::kGear * where[i];
    RC_ASSERT(std::abs(rig.hardware.travelled()[i] + home - rig.seen().motors[i]) < 2 * kIncrement);
    RC_ASSERT(std::abs(rig.seen().joints[i] - rig.seen().motors[i] / GearedModel::kGear) < 1e-12);
  }
  RC_ASSERT(rig.seen().fault.code == ErrorCode::none);
  RC_ASSERT(!rig.send(joint_command(JointVector::Zero(4), 3000, 3000)));
  rig.run(3200);
  RC_ASSERT((rig.seen().joints).norm() < 1e-3);
}

/// The switches are `length` rad long instead of reaching to the limit.
void shorten_switches(FaultyHardware& hardware, double length) {
  hardware.rewire = [&hardware, length](HardwareInput& input) {
    const RobotParameters parameters = Switched().parameters();
    for (std::size_t i = 0; i < 4; ++i) {
      const AxisParameters& axis = parameters.axes[i];
      const auto k = static_cast<Eigen::Index>(i);
      const double shaft = GearedModel::kGear * Placed::where()[k] + hardware.travelled()[k];
      const double beyond = std::copysign(1.0, axis.synchro_coarse) * (shaft - axis.motor_synchro) - std::numbers::pi;
      input.switches[i].synchro = beyond >= 0 && beyond <= length;
    }
  };
}

TEST(Synchronisation, FindsTheAbsolutePositionsFromAnywhereWithinTheLimits) {
  EXPECT_TRUE(rc::check([] { check_from(random_vector(4, 0.99)); }));
}

// an axis beyond its switch reverses at its limit switch
TEST(Synchronisation, FindsThemAlsoWithShortSwitches) {
  EXPECT_TRUE(rc::check([] {
    check_from(random_vector(4, 0.99),
               [](FaultyHardware& hardware) { shorten_switches(hardware, 2 * std::numbers::pi); });
  }));
}

// ... and a switch that is shorter than the stop is first left on its far side
TEST(Synchronisation, FindsThemWithSwitchesShorterThanTheStop) {
  EXPECT_TRUE(rc::check(
      [] { check_from(random_vector(4, 0.99), [](FaultyHardware& hardware) { shorten_switches(hardware, 0.5); }); }));
}

/// Position of the robot for the tests of faults: beyond the zero pulses, before the switches.
class Ready : public Switched {
 public:
  Ready() {
    parameters_.home = JointVector::Constant(4, -0.1);
    parameters_.home[1] = -0.2;
  }
};

/// Synchronises; returns the error of the reply.
ErrorReport error_of(Rig<Ready>& rig) {
  rig.replies.clear();
  EXPECT_FALSE(rig.send(command_of(CommandKind::synchronise)));
  while (rig.replies.empty() && rig.now < 100'000) rig.tick();
  EXPECT_EQ(rig.replies.size(), 1u);
  return rig.replies.empty() ? ErrorReport{} : rig.replies[0].state.error;
}

TEST(Synchronisation, SwitchThatNeverOpensIsAHardwareErrorAtTheLimitSwitch) {
  Rig<Ready> rig(true, false);
  rig.hardware.rewire = [](HardwareInput& input) { input.switches[3].synchro = true; };
  EXPECT_EQ(error_of(rig).code, ErrorCode::synchronisation_failed);
  EXPECT_EQ(rig.seen().fault.axis, 3);
  rig.run(500);
  EXPECT_FALSE(rig.hardware.powered);
  EXPECT_NEAR(rig.hardware.travelled()[3], 140, 3) << "from -10 to the limit switch at 130, and the stop";
}

TEST(Synchronisation, SwitchThatSticksIsAHardwareError) {
  Rig<Ready> rig(true, false);
  bool met = false;
  rig.hardware.rewire = [&met](HardwareInput& input) {
    input.switches[3].synchro = met = met || input.switches[3].synchro;
  };
  EXPECT_EQ(error_of(rig).code, ErrorCode::synchronisation_failed);
  EXPECT_TRUE(met);
  EXPECT_NEAR(rig.hardware.travelled()[3], 140, 3);
}

TEST(Synchronisation, AnEncoderWithoutZeroPulseIsOneWithinThreeTurns) {
  Rig<Ready> rig(true, false);
  rig.hardware.rewire = [](HardwareInput& input) { input.switches[3].zero_pulse = false; };
  EXPECT_EQ(error_of(rig).code, ErrorCode::synchronisation_failed);
  EXPECT_EQ(rig.seen().fault.axis, 3);
  rig.run(500);
  // from -10 to the switch's edge at s - pi and three turns back
  EXPECT_NEAR(rig.hardware.travelled()[3], -5.9 - std::numbers::pi + 6 * std::numbers::pi, 1);
}

TEST(Synchronisation, OnlySlowRelativeMotorMotionIsAllowedBefore) {
  Rig<Switched> rig(true, false);
  RobotCommand motor = joint_command(JointVector::Constant(4, 1.0), 500, 500);
  motor.kind = CommandKind::motor;
  ASSERT_TRUE(rig.send(motor));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::not_synchronised);
  for (const CommandKind kind : {CommandKind::joint, CommandKind::pose, CommandKind::joint_velocity, CommandKind::twist,
                                 CommandKind::use_model}) {
    RobotCommand command = motor;
    command.kind = kind;
    command.relative = true;
    ASSERT_TRUE(rig.send(command));
    EXPECT_EQ(rig.answer.state.error.code, ErrorCode::not_synchronised);
  }
  motor.relative = true;
  ASSERT_FALSE(rig.send(motor));
  rig.run(600);
  EXPECT_NEAR(rig.seen().motors[2], 1.0, 2 * kIncrement);
  motor.motion_steps = motor.reply_step = 50;
  ASSERT_TRUE(rig.send(motor));
  EXPECT_NE(rig.answer.state.error.code, ErrorCode::none);  // too fast: 37 rad/s
}

/// Recovers; returns the code of the answer.
ErrorCode recover(Rig<Switched>& rig) {
  rig.replies.clear();
  EXPECT_FALSE(rig.send(command_of(CommandKind::recover)));
  rig.run(5);
  EXPECT_EQ(rig.replies.size(), 1u);
  return rig.replies.empty() ? ErrorCode::busy : rig.replies[0].state.error.code;
}

TEST(Synchronisation, BeforeItAFaultAndTheEmergencyStopAreLatchedToo) {
  Rig<Switched> rig(true, false);
  RobotCommand motor = joint_command(JointVector::Constant(4, 1.0), 500, 500);
  motor.kind = CommandKind::motor;
  motor.relative = true;
  const auto expect_stopped = [&](ErrorCode code) {
    EXPECT_FALSE(rig.hardware.powered);
    EXPECT_EQ(rig.seen().fault.code, code);
    EXPECT_TRUE(rig.send(motor));
    EXPECT_EQ(rig.answer.state.error.code, code) << "latched";
  };
  const auto expect_held = [&] {
    EXPECT_TRUE(rig.hardware.powered);
    EXPECT_TRUE(rig.seen().desired.at_rest());
    EXPECT_FALSE(rig.seen().synchronised);
  };
  expect_held();
  rig.hardware.fault = ErrorCode::drive_fault;  // at rest
  rig.run(2);
  rig.hardware.fault = ErrorCode::none;
  expect_stopped(ErrorCode::drive_fault);
  EXPECT_EQ(recover(rig), ErrorCode::none);
  expect_held();

  ASSERT_FALSE(rig.send(motor));
  rig.run(250);
  ASSERT_FALSE(rig.seen().desired.at_rest());
  rig.operators.press();  // during the motion
  rig.run(2);
  EXPECT_TRUE(rig.hardware.powered) << "it brakes first";
  EXPECT_FALSE(rig.seen().desired.at_rest());
  rig.run(300);
  expect_stopped(ErrorCode::emergency_stop);
  EXPECT_LT(rig.seen().motors[2], 1.0 - 10 * kIncrement) << "it did not continue to the end";
  EXPECT_EQ(recover(rig), ErrorCode::emergency_stop) << "it has not been reset";
  rig.operators.reset();
  EXPECT_EQ(recover(rig), ErrorCode::none);
  expect_held();
}

TEST(Synchronisation, ASwitchThatNeverClosesIsAHardwareError) {
  Rig<Switched> rig(true, false);
  rig.hardware.blind = true;
  ASSERT_FALSE(rig.send(command_of(CommandKind::synchronise)));
  while (rig.replies.empty() && rig.now < 100'000) rig.tick();
  ASSERT_EQ(rig.replies.size(), 1u);
  const ErrorReport& error = rig.replies[0].state.error;
  EXPECT_EQ(error.error_class, ErrorClass::hardware);
  EXPECT_EQ(error.code, ErrorCode::synchronisation_failed);
  EXPECT_EQ(rig.seen().fault.axis, 3);
  rig.run(500);
  EXPECT_FALSE(rig.hardware.powered);
  // repaired: it can be tried again
  rig.hardware.blind = false;
  rig.replies.clear();
  ASSERT_FALSE(rig.send(command_of(CommandKind::recover)));
  rig.run(5);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.error_class, ErrorClass::none);
  rig.replies.clear();
  ASSERT_FALSE(rig.send(command_of(CommandKind::synchronise)));
  while (rig.replies.empty() && rig.now < 300'000) rig.tick();
  EXPECT_TRUE(rig.seen().synchronised);
}

TEST(Synchronisation, IsRefusedTwiceAndWithoutSwitches) {
  Rig<Switched> rig;
  ASSERT_TRUE(rig.send(command_of(CommandKind::synchronise)));
  EXPECT_EQ(rig.answer.state.error.detail.view(), "already synchronised");
  Rig<Gantry> bare(true, false);
  ASSERT_TRUE(bare.send(command_of(CommandKind::synchronise)));
  EXPECT_EQ(bare.answer.state.error.detail.view(), "axis x has no synchronisation switch");
}

}  // namespace
}  // namespace mrroc::edp::synchroniser_test
