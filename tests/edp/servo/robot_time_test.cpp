// The servo of a robot that keeps the time: its ticks lie beside the grid, its set-points must not show it.
#include <gtest/gtest.h>

#include <cmath>

#include "edp/rig.hpp"

namespace mrroc::edp::robot_time_test {
namespace {

/// A robot that is at its last set-point.
class ExactRobot final : public Hardware {
 public:
  explicit ExactRobot(const RobotModel& model) { model.joints_to_motors(model.parameters().home, position); }
  void open() override {}
  void enable(bool) noexcept override {}
  void read(Tick, HardwareInput& input) noexcept override {
    input.motors = position;
    input.current = JointVector::Zero(position.size());
    input.synchronised = true;
    input.fault = fault;
  }
  void set_points(const JointVector& shafts, const JointVector&) noexcept override { position = shafts; }
  void write(Tick, const JointVector&) noexcept override {}
  void set_origin(const JointVector&) noexcept override {}

  JointVector position;
  ErrorCode fault = ErrorCode::none;
};

/// Ticks at `phase` + n `rate`; the largest speed and acceleration between its set-points.
class BesideTheGrid {
 public:
  BesideTheGrid(double rate, double phase) : rate_(rate), phase_(phase) {
    model.change().axes[0].stuck_max = 1e9;
    effector.enable(true);
    run(10);
  }

  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) tick();
  }
  void tick() {
    const double place = phase_ + rate_ * n_++;
    const double whole = std::floor(place);
    servo.tick(static_cast<Tick>(whole), place - whole, place);
    Reply reply;
    while (effector.poll(reply)) replies.push_back(reply);
    const double position = servo.snapshot().desired.position[0];
    const double velocity = (position - position_) / (rate_ * kPeriod);
    if (n_ > 3) {
      fastest = std::max(fastest, std::abs(velocity));
      hardest = std::max(hardest, std::abs(velocity - velocity_) / (rate_ * kPeriod));
    }
    position_ = position;
    velocity_ = velocity;
  }
  bool send(const RobotCommand& command) {
    Reply refused;
    return !effector.accept(command, ++number_, refused);
  }
  const AxisParameters& axis() const { return model.parameters().axes[0]; }

  Slide model;
  ExactRobot robot{model};
  ServoChannel channel;
  ModelSet models{model};
  Servo servo{models, robot, kPeriod, channel};
  Effector effector{models, kPeriod, channel};
  std::vector<Reply> replies;
  double fastest = 0, hardest = 0;

 private:
  double rate_, phase_, position_ = 0, velocity_ = 0;
  int n_ = 0;
  std::uint64_t number_ = 0;
};

class RobotTime : public testing::TestWithParam<double> {
 protected:
  void expect_within_limits(const BesideTheGrid& rig) {
    EXPECT_LE(rig.fastest, rig.axis().velocity_max * 1.0001);
    EXPECT_LE(rig.hardest, rig.axis().acceleration_max * 1.01);
    EXPECT_GT(rig.fastest, 0.1 * rig.axis().velocity_max);
  }
};

TEST_P(RobotTime, AMotionIsAsSmoothAsOnTheGrid) {
  for (const double phase : {0.0, 0.37, 0.999}) {
    BesideTheGrid rig(GetParam(), phase);
    ASSERT_TRUE(rig.send(joint_command(one(1.25), 1500, 1500)));
    rig.run(1700);
    EXPECT_EQ(rig.servo.snapshot().fault.code, ErrorCode::none);
    EXPECT_NEAR(rig.servo.snapshot().desired.position[0], 1.25, 1e-12);
    ASSERT_EQ(rig.replies.size(), 1u);
    EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::none);
    expect_within_limits(rig);
  }
}

TEST_P(RobotTime, SuccessiveMotionsJoin) {
  BesideTheGrid rig(GetParam(), 0.6);
  for (int step = 1; step <= 4; ++step) {
    RobotCommand command = joint_command(one(0.25 + 0.2 * step), 400, 300);
    command.joint_velocity = one(step < 4 ? 0.3 : 0.0);
    ASSERT_TRUE(rig.send(command));
    const std::size_t before = rig.replies.size();
    for (int i = 0; i < 500 && rig.replies.size() == before; ++i) rig.tick();
    ASSERT_EQ(rig.replies.size(), before + 1);
    EXPECT_EQ(rig.replies.back().state.error.code, ErrorCode::none);
  }
  rig.run(200);
  EXPECT_NEAR(rig.servo.snapshot().desired.position[0], 1.05, 1e-12);
  EXPECT_EQ(rig.servo.snapshot().counters.stops, 0u);
  expect_within_limits(rig);
}

TEST_P(RobotTime, ARobotWithoutASuccessorBrakesWithinItsLimits) {
  BesideTheGrid rig(GetParam(), 0.8);
  RobotCommand command = joint_command(one(0.5), 600, 500);
  command.joint_velocity = one(0.4);
  ASSERT_TRUE(rig.send(command));
  rig.run(1500);
  EXPECT_EQ(rig.servo.snapshot().counters.stops, 1u);
  EXPECT_TRUE(rig.servo.snapshot().desired.at_rest());
  expect_within_limits(rig);
}

TEST_P(RobotTime, AFaultInMotionStopsWithinLimitsAtEveryTick) {
  for (int at = 200; at < 1400; at += 37) {
    BesideTheGrid rig(GetParam(), at * 0.013);
    ASSERT_TRUE(rig.send(joint_command(one(1.25), 1500, 1500)));
    rig.run(at);
    rig.robot.fault = ErrorCode::limit_switch;
    rig.run(1000);
    EXPECT_TRUE(rig.servo.snapshot().desired.at_rest());
    EXPECT_LE(rig.fastest, rig.axis().velocity_max * 1.0001) << at;
    EXPECT_LE(rig.hardest, rig.axis().acceleration_max * 1.01) << at;
  }
}

INSTANTIATE_TEST_SUITE_P(Rates, RobotTime, testing::Values(1.0, 0.9995, 1.0005, 0.99, 1.01, 2.0));

}  // namespace
}  // namespace mrroc::edp::robot_time_test
