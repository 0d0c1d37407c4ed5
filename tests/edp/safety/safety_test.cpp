// Causes and categories of a stop, and the conditions for the next motion.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "edp/safety/stop_category.hpp"
#include "safe_rig.hpp"

namespace mrroc::edp::safety_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Ticks until the drives are off; every set-point on the way follows from the one before within the limits.
void expect_smooth_stop(SafeRig& rig) {
  const AxisParameters& axis = rig.model.parameters().axes[0];
  DesiredState before = rig.seen().desired;
  for (int i = 0; i < 500 && rig.hardware.powered; ++i) {
    rig.tick();
    if (!rig.hardware.powered) break;
    const DesiredState& now = rig.seen().desired;
    EXPECT_LE(std::abs(now.velocity[0] - before.velocity[0]), axis.acceleration_max * kPeriod * (1 + 1e-6));
    EXPECT_LE(std::abs(now.acceleration[0] - before.acceleration[0]), axis.jerk_max * kPeriod * (1 + 1e-6));
    EXPECT_LE(std::abs(now.velocity[0]), std::abs(before.velocity[0]) + 1e-12) << "a stop gets slower";
    before = now;
  }
}

struct Event {
  const char* name;
  ErrorCode code;  ///< `none`: no fault
  StopCategory category;
  std::function<void(SafeRig&)> happens;
  friend void PrintTo(const Event& event, std::ostream* out) { *out << event.name; }
};

const Event kEvents[] = {
    {"DriveFault", ErrorCode::drive_fault, StopCategory::drives_off,
     [](SafeRig& rig) { rig.hardware.fault = ErrorCode::drive_fault; }},
    {"SilentHardware", ErrorCode::hardware_silent, StopCategory::drives_off,
     [](SafeRig& rig) { rig.hardware.fault = ErrorCode::hardware_silent; }},
    {"LostPositions", ErrorCode::drive_fault, StopCategory::drives_off,
     [](SafeRig& rig) { rig.hardware.positions_lost = true; }},
    {"PositionNotFinite", ErrorCode::encoder_fault, StopCategory::drives_off,
     [](SafeRig& rig) { rig.hardware.spoil = [](HardwareInput& input) { input.motors[0] = kNan; }; }},
    {"PositionJumps", ErrorCode::encoder_fault, StopCategory::drives_off,
     [](SafeRig& rig) { rig.hardware.spoil = [](HardwareInput& input) { input.motors[0] += 5; }; }},
    {"CurrentNotFinite", ErrorCode::drive_fault, StopCategory::drives_off,
     [](SafeRig& rig) { rig.hardware.spoil = [](HardwareInput& input) { input.current[0] = kNan; }; }},
    {"FollowingError", ErrorCode::following_error, StopCategory::stop_then_off,
     [](SafeRig& rig) {
       rig.model.change().axes[0].current_max_time = 1e9;
       rig.model.change().axes[0].following_error_max = 5;
       rig.hardware.jam = true;
     }},
    {"StuckAxis", ErrorCode::axis_stuck, StopCategory::drives_off,
     [](SafeRig& rig) {
       rig.model.change().axes[0].current_max_time = 1e9;
       rig.model.change().axes[0].stuck_max = 5;
       rig.hardware.jam = rig.hardware.stuck = true;
     }},
    {"Overspeed", ErrorCode::overspeed, StopCategory::drives_off,
     [](SafeRig& rig) {
       rig.model.change().axes[0].velocity_max =
           0.9 * rig.seen().joint_velocity.cwiseAbs().maxCoeff() / MotionWatch::kOverspeed;
     }},
    {"OverCurrent", ErrorCode::over_current, StopCategory::stop_then_off,
     [](SafeRig& rig) { rig.hardware.spoil = [](HardwareInput& input) { input.current[0] = -25; }; }},
    {"LimitSwitch", ErrorCode::limit_switch, StopCategory::stop_then_off,
     [](SafeRig& rig) { rig.hardware.spoil = [](HardwareInput& input) { input.switches[0].upper_limit = true; }; }},
    {"OperatorsEmergencyStop", ErrorCode::emergency_stop, StopCategory::stop_then_off,
     [](SafeRig& rig) { rig.operators.press(); }},
    {"EmergencyStopInput", ErrorCode::emergency_stop, StopCategory::stop_then_off,
     [](SafeRig& rig) { rig.hardware.spoil = [](HardwareInput& input) { input.inputs.set(kTerminal, false); }; }},
    {"SwitchedOff", ErrorCode::none, StopCategory::stop_then_off, [](SafeRig& rig) { rig.effector.enable(false); }},
    {"NobodyCommands", ErrorCode::none, StopCategory::stop_and_hold, [](SafeRig&) {}},
};

class Stops : public testing::TestWithParam<Event> {};

TEST_P(Stops, StopTheRobotInTheirCategory) {
  const Event& event = GetParam();
  SafeRig rig(false);
  rig.hardware.close(kTerminal);
  rig.servo.use_emergency_terminal(kTerminal);
  rig.run(1);
  rig.effector.enable(true);
  rig.run(2);
  ASSERT_TRUE(rig.hardware.powered);
  RobotCommand command = joint_command(one(0.5), 500, 400);  // the motion does not end at rest
  command.joint_velocity = one(0.5);
  ASSERT_FALSE(rig.send(command)) << rig.answer.state.error.detail.view();
  rig.run(250);
  ASSERT_GT(rig.seen().desired.velocity[0], 0.2);
  ASSERT_TRUE(rig.replies.empty());

  const std::uint32_t epoch = rig.seen().epoch;
  event.happens(rig);
  for (int i = 0; i < 400 && rig.seen().epoch == epoch; ++i) rig.tick();  // until the servo leaves the planned motion
  EXPECT_EQ(rig.seen().fault.code, event.code);
  if (event.code != ErrorCode::none) {
    EXPECT_EQ(stop_category(event.code), event.category);
  }
  EXPECT_EQ(rig.hardware.powered, event.category != StopCategory::drives_off) << "in the same tick";
  if (event.category == StopCategory::drives_off) {
    EXPECT_TRUE(rig.seen().desired.at_rest());
  } else {
    EXPECT_FALSE(rig.seen().desired.at_rest());
    expect_smooth_stop(rig);
  }
  rig.run(50);
  EXPECT_TRUE(rig.seen().desired.at_rest());
  EXPECT_EQ(rig.hardware.powered, event.category == StopCategory::stop_and_hold);
  ASSERT_EQ(rig.replies.size(), 1u) << "one answer";
  const ErrorReport& error = rig.replies[0].state.error;
  if (event.code != ErrorCode::none) {
    EXPECT_EQ(error.code, event.code);
    EXPECT_EQ(error.error_class, ErrorClass::hardware);
    ASSERT_TRUE(rig.send(by(-0.1)));
    EXPECT_EQ(rig.answer.state.error.code, event.code) << "latched";
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Stops, testing::ValuesIn(kEvents),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(OverCurrent, CurrentBeyondItsTimeIsAFault) {
  SafeRig rig;
  rig.run(10);
  const auto overload = [&rig](Tick ticks) {
    rig.hardware.spoil = [](HardwareInput& input) { input.current[0] = 20; };
    rig.run(ticks);
    rig.hardware.spoil = nullptr;
    rig.run(5);
  };
  for (int i = 0; i < 3; ++i) overload(50);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none) << "0.1 s at a time";
  overload(51);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::over_current);
  EXPECT_EQ(std::get<Excess>(rig.seen().fault.detail).value, 20);
  EXPECT_EQ(recover(rig), ErrorCode::none);
  rig.run(200);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
}

TEST(OverCurrent, EveryCurrentIsAllowedWithoutATime) {
  Rig<Slide> rig;
  rig.hardware.spoil = [](HardwareInput& input) { input.current[0] = 200; };
  rig.run(5000);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
}

TEST(LimitSwitch, AcceptsOnlyMotionAwayFromIt) {
  for (const double direction : {1.0, -1.0}) {
    SafeRig rig;
    const double edge = GearedModel::kGear * (0.25 + direction * 0.3);
    rig.hardware.spoil = [=](HardwareInput& input) {
      const bool on = direction * (input.motors[0] - edge) > 0;
      (direction > 0 ? input.switches[0].upper_limit : input.switches[0].lower_limit) = on;
    };
    rig.send(by(direction * 0.6, 800));
    rig.run(1000);
    ASSERT_EQ(rig.seen().fault.code, ErrorCode::limit_switch);
    ASSERT_FALSE(rig.hardware.powered);
    const double stands = rig.seen().joints[0];
    ASSERT_GT(direction * (stands - 0.25), 0.3);
    ASSERT_EQ(recover(rig), ErrorCode::none);
    rig.run(100);
    ASSERT_TRUE(rig.hardware.powered) << "it may rest there";

    RobotCommand velocity = by(0);
    velocity.kind = CommandKind::joint_velocity;
    velocity.joint_velocity = one(direction * 0.1);
    RobotCommand back_onto_it = by(-direction * 0.01);
    back_onto_it.joint_velocity = one(direction * 0.5);  // a stop from there ends farther out
    for (const RobotCommand& farther : {by(direction * 0.001), velocity, back_onto_it}) {
      ASSERT_TRUE(rig.send(farther));
      EXPECT_EQ(rig.answer.state.error.code, ErrorCode::limit_switch) << rig.answer.state.error.detail.view();
      EXPECT_EQ(rig.answer.state.error.error_class, ErrorClass::non_fatal);
    }
    ASSERT_FALSE(rig.send(by(-direction * 0.5, 800))) << rig.answer.state.error.detail.view();
    rig.run(1000);
    EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
    EXPECT_NEAR(rig.seen().joints[0], stands - direction * 0.5, 1e-3);
    // then the switch is reached again
    ASSERT_FALSE(rig.send(by(direction * 0.6, 800)));
    rig.run(1000);
    EXPECT_EQ(rig.seen().fault.code, ErrorCode::limit_switch);
  }
}

TEST(LimitSwitch, AxisAtTheEdgeIsNotStoppedAgain) {
  SafeRig rig;
  bool on = true;
  rig.hardware.spoil = [&on](HardwareInput& input) { input.switches[0].lower_limit = on; };
  rig.run(5);
  ASSERT_EQ(rig.seen().fault.code, ErrorCode::limit_switch);
  ASSERT_EQ(recover(rig), ErrorCode::none);
  for (int i = 0; i < 20; ++i) {
    on = !on;
    rig.run(2);
  }
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
}

}  // namespace
}  // namespace mrroc::edp::safety_test
