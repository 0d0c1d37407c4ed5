// The driver below the EDP's own servo: its watches judge what the driver reads, and it orders power and recovery.
#include "edp/servo/servo.hpp"

#include <gtest/gtest.h>

#include "drivers/ur/ur_rig.hpp"
#include "edp/command/effector.hpp"

namespace mrroc::ur::servo_test {
namespace {

class ServoRig {
 public:
  /// `emergency_stop`: digital input that presses it; -1: none does.
  explicit ServoRig(Interface interface, int emergency_stop = -1) : model_(interface) {
    model_.change().home << 0, -1.5, 1.5, -1.5, -1.5, 0;
    if (emergency_stop >= 0) release(emergency_stop);
    hardware_ = std::make_unique<UrHardware>(controller.driver_options(), model_, kPeriod);
    hardware_->open();
    ticker_.emplace(*hardware_->clock(), clock::monotonic_ns(), kPeriod);
    servo_ = std::make_unique<edp::Servo>(models_, *hardware_, kPeriod, channel_);
    if (emergency_stop >= 0) servo_->use_emergency_terminal(emergency_stop);
    servo_->use_emergency_stop(emergency_stop_);
    effector_ = std::make_unique<edp::Effector>(models_, kPeriod, channel_);
    effector_->enable(true);
  }

  /// The next tick of the controller, as the servo's thread.
  void tick() {
    const auto [present, ahead, measured] = ticker_->wait_next();
    servo_->tick(present, ahead, measured);
    edp::Reply reply;
    while (effector_->poll(reply)) reply_ = reply;
  }

  bool tick_until(const std::function<bool()>& condition) {
    for (int i = 0; i < 20000; ++i) {
      tick();
      if (condition()) return true;
    }
    return false;
  }

  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }

  bool is_on() const { return servo_->snapshot().enabled(); }
  ErrorCode fault() const { return servo_->snapshot().fault.code; }

  void start_move(const JointVector& way) {
    RobotCommand command;
    command.kind = CommandKind::joint;
    command.relative = true;
    command.joints = way;
    command.motion_steps = command.reply_step = 400;
    send(command);
  }

  bool recover() {
    RobotCommand command;
    command.kind = CommandKind::recover;
    send(command);
    return tick_until([this] { return answered(); }) && is_on();
  }

  /// The last command has its answer.
  bool answered() const { return reply_.command == number_; }
  ErrorCode answer() const { return reply_.state.error.code; }

  /// The emergency stop that is wired to this input; `release` does not reset it.
  void press() {
    controller.servers.with([](VirtualController& c) { c.set_inputs(0, 0, 0); });
  }
  void release(int input) {
    controller.servers.with([input](VirtualController& c) { c.set_inputs(std::uint64_t{1} << input, 0, 0); });
  }
  void reset() { emergency_stop_.reset(); }

  void leave() { servo_->leave(); }
  bool drives_on() const { return servo_->drives_on(); }

  Controller controller;

 private:
  void send(const RobotCommand& command) {
    edp::Reply refused;
    if (effector_->accept(command, ++number_, refused)) reply_ = refused;
  }

  SixJoints model_;
  std::unique_ptr<UrHardware> hardware_;
  clock::EmergencyStop emergency_stop_;
  edp::ServoChannel channel_;
  edp::ModelSet models_{model_};
  std::unique_ptr<edp::Servo> servo_;
  std::unique_ptr<edp::Effector> effector_;
  edp::Reply reply_;
  std::uint64_t number_ = 0;
  std::optional<edp::RobotTicker> ticker_;
};

JointVector way() {
  JointVector way(6);
  way << 0.2, -0.1, 0.1, 0, 0.05, -0.2;
  return way;
}

class UrServo : public testing::TestWithParam<Interface> {};

TEST_P(UrServo, Moves) {
  ServoRig rig(GetParam());
  ASSERT_TRUE(rig.tick_until([&] { return rig.is_on(); })) << describe(rig.fault());
  const Six before = rig.controller.ask([](VirtualController& c) { return c.position(); });
  rig.start_move(way());
  ASSERT_TRUE(rig.tick_until([&] { return rig.answered(); }));
  EXPECT_EQ(rig.answer(), ErrorCode::none) << describe(rig.answer());
  rig.ticks(200);
  const Six after = rig.controller.ask([](VirtualController& c) { return c.position(); });
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(after[i] - before[i], way()[static_cast<Eigen::Index>(i)], 1e-3) << i;
  EXPECT_EQ(rig.fault(), ErrorCode::none);
}

TEST_P(UrServo, RecoversFromAProtectiveStopInMotion) {
  ServoRig rig(GetParam());
  ASSERT_TRUE(rig.tick_until([&] { return rig.is_on(); })) << describe(rig.fault());
  rig.start_move(way());
  rig.ticks(100);
  rig.controller.servers.with([](VirtualController& c) { c.protective_stop(); });
  ASSERT_TRUE(rig.tick_until([&] { return rig.fault() == ErrorCode::drive_fault; }));
  ASSERT_TRUE(rig.tick_until([&] { return !rig.drives_on(); }));
  ASSERT_TRUE(rig.recover()) << describe(rig.fault());
  rig.start_move(-0.5 * way());
  ASSERT_TRUE(rig.tick_until([&] { return rig.answered(); }));
  EXPECT_EQ(rig.answer(), ErrorCode::none) << describe(rig.answer());
}

TEST_P(UrServo, LeavesInMotionWithAStop) {
  ServoRig rig(GetParam());
  ASSERT_TRUE(rig.tick_until([&] { return rig.is_on(); })) << describe(rig.fault());
  rig.start_move(way());
  rig.ticks(100);
  rig.leave();
  ASSERT_TRUE(rig.tick_until([&] { return !rig.drives_on(); }));
  const auto velocity = rig.controller.ask([](VirtualController& c) { return c.velocity(); });
  for (const double rate : velocity) EXPECT_NEAR(rate, 0, 2e-3);
  EXPECT_EQ(rig.fault(), ErrorCode::none) << describe(rig.fault());
}

/// The key `emergency_stop = 9` of a robot: a configurable input of the controller.
TEST_P(UrServo, AnInputOfTheControllerPressesTheEmergencyStop) {
  constexpr int kInput = 9;
  ServoRig rig(GetParam(), kInput);
  ASSERT_TRUE(rig.tick_until([&] { return rig.is_on(); })) << describe(rig.fault());
  rig.start_move(way());
  rig.ticks(100);
  rig.press();
  ASSERT_TRUE(rig.tick_until([&] { return rig.fault() == ErrorCode::emergency_stop; }));
  ASSERT_TRUE(rig.tick_until([&] { return !rig.drives_on(); }));
  EXPECT_TRUE(rig.tick_until([&] {
    const Six rates = rig.controller.ask([](VirtualController& c) { return c.velocity(); });
    return std::all_of(rates.begin(), rates.end(), [](double rate) { return std::abs(rate) < 2e-3; });
  })) << "the control script has stopped it";
  rig.release(kInput);
  rig.ticks(50);
  EXPECT_FALSE(rig.recover()) << "it stays latched until the operator resets it";
  rig.reset();
  EXPECT_TRUE(rig.recover()) << describe(rig.fault());
}

INSTANTIATE_TEST_SUITE_P(UrHardware, UrServo, testing::Values(Interface::position, Interface::velocity));

}  // namespace
}  // namespace mrroc::ur::servo_test
