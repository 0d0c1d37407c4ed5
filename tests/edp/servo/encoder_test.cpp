// Faults that encoder readings alone reveal: a robot above its speed limit, dead encoders.
#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <vector>

#include "edp/rig.hpp"

namespace mrroc::edp::encoder_test {
namespace {

/// Recovers; returns the code of the answer.
ErrorCode recover(Rig<Slide>& rig) {
  RobotCommand command;
  command.kind = CommandKind::recover;
  rig.replies.clear();
  EXPECT_FALSE(rig.send(command));
  rig.run(3);
  EXPECT_EQ(rig.replies.size(), 1u);
  return rig.replies.empty() ? ErrorCode::busy : rig.replies[0].state.error.code;
}

/// The verdict of a watch that reads these positions of a slide's shaft, tick by tick, in parts of the distance of a
/// period at full speed. Each reading may be late by up to the given time. `homing`: 0 when the slide's drive homes on
/// its own.
Fault after_ways(const std::vector<double>& ways, const std::vector<double>& late = {}, int homing = -1) {
  const Slide model;
  MotionWatch watch(kPeriod);
  const double full = model.parameters().axes[0].velocity_max * kPeriod;
  JointVector joints = one(0), velocity = one(ways.front() * full / kPeriod);
  Fault fault = watch.check(model, {joints, velocity, joints, joints, one(0)}, {1}, true, homing);
  Tick tick = 1;
  for (const double way : ways) {
    if (fault.code != ErrorCode::none) break;
    joints[0] += way * full;
    velocity[0] = way * full / kPeriod;
    const JointVector motors = GearedModel::kGear * joints;
    const double lateness = late.empty() ? 0 : late[tick - 1];
    fault = watch.check(model, {joints, velocity, motors, motors, one(0)}, {static_cast<double>(++tick), lateness},
                        true, homing);
  }
  fault.tick = tick;
  return fault;
}

TEST(Overspeed, IsDetectedATickAheadAndNotInAnOscillation) {
  const Fault runaway = after_ways({0.5, 0.5, 0.9, 1.3, 1.7});
  EXPECT_EQ(runaway.code, ErrorCode::overspeed);
  EXPECT_EQ(runaway.tick, 4u) << "it would reach 1.3 times its limit";
  EXPECT_EQ(after_ways({-0.5, -0.5, -0.9, -1.3}).tick, 4u);
  std::vector<double> steady(100, 1.1), trembling(100, 1.0);
  EXPECT_EQ(after_ways(steady).code, ErrorCode::none);
  for (std::size_t i = 0; i < trembling.size(); ++i) trembling[i] += i % 2 == 0 ? 0.01 : -0.01;  // a whole increment
  EXPECT_EQ(after_ways(trembling).code, ErrorCode::none);
  steady.back() = 1.13;
  EXPECT_EQ(after_ways(steady).code, ErrorCode::none) << "two increments more";
  EXPECT_EQ(after_ways(std::vector<double>(10, 1.17)).code, ErrorCode::overspeed);
}

TEST(Overspeed, IgnoresTheSpeedStepOfAHomingDrive) {
  const std::vector<double> at_once{0, 0, 0, 1, 1, 1, 1, 1, 1, 0, -1, -1, -1, -1};
  EXPECT_EQ(after_ways(at_once, {}, 0).code, ErrorCode::none);
  EXPECT_EQ(after_ways(at_once).code, ErrorCode::overspeed) << "the servo sets this speed";
  EXPECT_EQ(after_ways(std::vector<double>(10, 1.17), {}, 0).code, ErrorCode::overspeed) << "but it may not be faster";
}

TEST(Overspeed, IgnoresReadingsOfALateServo) {
  // drives that measure at the request of the late servo, and drives with their own clock
  for (const bool when_asked : {true, false}) {
    std::mt19937 random(20);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<double> late, ways;
    double before = 1;
    for (int i = 0; i < 2000; ++i) {
      late.push_back(i % 3 == 0 ? 0.9 * share(random) : 0.1 * share(random));
      const double taken = 2 + i + (when_asked ? late.back() : late.back() * share(random));
      ways.push_back(taken - before);
      before = taken;
    }
    EXPECT_EQ(after_ways(ways, late).code, ErrorCode::none);
    for (double& way : ways) way *= 2;
    EXPECT_EQ(after_ways(ways, late).code, ErrorCode::overspeed);
  }
}

TEST(Overspeed, IsDetectedOnABusThatAnswersInTime) {
  const std::vector<double> usual(100, 0.15);
  EXPECT_EQ(after_ways(std::vector<double>(100, 1.1), usual).code, ErrorCode::none);
  EXPECT_EQ(after_ways(std::vector<double>(100, 1.25), usual).code, ErrorCode::overspeed);
}

TEST(Encoder, AcceptsAReadingThatReturnsAndRejectsOneThatStaysAway) {
  Rig<Slide> rig;
  double off = 5;
  rig.hardware.spoil = [&off](HardwareInput& input) { input.motors[0] += off; };
  rig.run(2);
  ASSERT_EQ(rig.seen().fault.code, ErrorCode::encoder_fault);
  EXPECT_EQ(rig.seen().fault.axis, 0);
  EXPECT_NEAR(rig.seen().joints[0], 0.25, 1e-4) << "an impossible reading is rejected";
  rig.run(5000);
  EXPECT_EQ(recover(rig), ErrorCode::encoder_fault) << "the position is lost permanently";
  off = 0;
  EXPECT_EQ(recover(rig), ErrorCode::none);
  EXPECT_NEAR(rig.seen().joints[0], 0.25, 1e-4);
}

TEST(Encoder, AxisMayHaveMovedAfterASilence) {
  for (const bool sure : {true, false}) {  // whether the first readings after it are new ones
    Rig<Slide> rig;
    rig.hardware.fault = ErrorCode::hardware_silent;
    rig.run(500);
    rig.hardware.spoil = [sure](HardwareInput& input) {
      input.motors[0] += 50;  // moved by hand, in a second
      if (!sure) input.time = 0;
    };
    rig.hardware.fault = ErrorCode::none;
    EXPECT_EQ(recover(rig), ErrorCode::none);
    EXPECT_NEAR(rig.seen().joints[0], 0.75, 1e-3);
    EXPECT_NEAR(rig.seen().desired.position[0], 0.75, 1e-3) << "and it stays there";
  }
}

/// It reaches no switch at any position.
class WatchedBelt : public Slide {
 public:
  WatchedBelt() {
    AxisParameters& axis = parameters_.axes[0];
    axis.motor_min = -1e6;
    axis.motor_max = 1e6;
    axis.stuck_max = 1;
    axis.stuck_current = 0;
  }
};

TEST(Encoder, ThatDiesAtRestMovesTheAxisByLessThanItsLimits) {
  for (const double beside : {0.5, 1.0, 20.0}) {  // increments between the last reading and the set-point
    Rig<WatchedBelt> rig;
    rig.run(10);
    const double read = rig.seen().motors[0] - beside * 2 * std::numbers::pi / 4000;
    rig.hardware.spoil = [read](HardwareInput& input) { input.motors[0] = read; };
    double fastest = 0;
    double before = rig.hardware.travelled()[0];
    Tick ticks = 0;
    for (; ticks < 1'000'000 && rig.hardware.powered; ++ticks) {
      rig.tick();
      fastest = std::max(fastest, std::abs(rig.hardware.travelled()[0] - before) / kPeriod / GearedModel::kGear);
      before = rig.hardware.travelled()[0];
    }
    EXPECT_EQ(rig.seen().fault.code, ErrorCode::axis_stuck) << "the set-point stands, after " << ticks;
    EXPECT_EQ(rig.seen().fault.axis, 0);
    const double limit = rig.model.parameters().axes[0].velocity_max;
    EXPECT_NEAR(std::get<Excess>(rig.seen().fault.detail).limit, MotionWatch::kPushed * limit, 1e-9);
    EXPECT_LE(fastest, 1.5 * limit) << beside;
    EXPECT_GE(fastest, limit) << "it was pushed: " << beside;
  }
}

TEST(Encoder, AxisHeldByStaticFrictionMayStand) {
  Rig<WatchedBelt> rig;
  rig.model.change().axes[0].stuck_current = rig.model.parameters().axes[0].current_max;
  rig.run(10);
  const double read = rig.seen().motors[0] - 0.03;
  rig.hardware.spoil = [read](HardwareInput& input) { input.motors[0] = read; };
  rig.run(20'000);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
}

/// Drives whose driver reports nothing.
class Mute final : public Hardware {
 public:
  void open() override {}
  void enable(bool on) noexcept override { powered = powered || on; }
  void read(Tick, HardwareInput& input) noexcept override { input.synchronised = true; }
  void write(Tick, const JointVector&) noexcept override {}
  void set_origin(const JointVector&) noexcept override {}
  bool powered = false;
};

TEST(Encoder, SilentDrivesAreNeverSwitchedOn) {
  Slide model;
  Mute hardware;
  ServoChannel hand_over;
  const ModelSet models(model);
  Servo servo(models, hardware, kPeriod, hand_over);
  Effector effector(models, kPeriod, hand_over);
  effector.enable(true);
  for (Tick tick = 0; tick < 10; ++tick) servo.tick(tick);
  EXPECT_EQ(servo.snapshot().fault.code, ErrorCode::encoder_fault);
  EXPECT_FALSE(hardware.powered);
}
}  // namespace
}  // namespace mrroc::edp::encoder_test
