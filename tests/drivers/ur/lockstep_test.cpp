// The driver and the stand-in of a controller in lockstep: each tick has one package and one answer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include "clock/wall/monotonic.hpp"
#include "drivers/ur/controller.hpp"

namespace mrroc::ur::lockstep_test {
namespace {

using testing::HasSubstr;

ControllerServers::Options lockstep_options() {
  ControllerServers::Options options = free_ports();
  options.lockstep_register = 24;
  return options;
}

/// A servo that ticks from 0, and the stand-in in a thread of its own, which counts its ticks.
class LockstepRig {
 public:
  explicit LockstepRig(Interface interface = Interface::position, double frequency = 0)
      : controller_(std::make_unique<Controller>(lockstep_options())), model_(interface) {
    UrOptions options = controller_->driver_options();
    options.lockstep = true;
    options.timeout = 10;
    options.watchdog = 0.1;
    options.missed_max = 1;
    options.frequency = frequency;
    hardware = std::make_unique<UrHardware>(options, model_, kPeriod);
    hardware->open();
    thread_ = std::thread([this] {
      while (!end_.load()) {
        if (controller_->servers.advance(60 * clock::kSecond) == Period::unanswered) unanswered_.store(true);
      }
    });
  }
  ~LockstepRig() {
    end_.store(true);
    hardware.reset();
    thread_.join();
    EXPECT_FALSE(unanswered_.load());
  }
  LockstepRig(const LockstepRig&) = delete;
  LockstepRig& operator=(const LockstepRig&) = delete;

  /// `meanwhile` acts while the controller waits for the answer of the tick.
  void tick(const std::function<void(VirtualController&)>& meanwhile = {}) {
    input = {};
    input.motors = JointVector::Constant(6, std::nan(""));
    hardware->read(now, input);
    if (meanwhile) controller_->servers.with(meanwhile);
    const bool on = enabled && !hardware->busy();
    if (!on) set = input.motors;
    if (on) set += rate * kPeriod;
    hardware->set_points(set, rate);
    hardware->write(now++, JointVector::Zero(6));
    // the clock of a deployment begins no tick before the controller has ended its period
    while (controller_->servers.periods() < now && !unanswered_.load()) std::this_thread::yield();
  }

  /// Number of ticks until it is not busy any more.
  int ticks_while_busy() {
    for (int count = 1; count < 5000; ++count) {
      tick();
      if (!hardware->busy()) return count;
    }
    return -1;
  }

  int start() {
    enabled = true;
    hardware->enable(true);
    return ticks_while_busy();
  }

  Six joints() {
    return controller_->ask([](VirtualController& c) { return c.position(); });
  }
  /// Ends the connections, as a stand-in that dies.
  void cut() { controller_->servers.cut(); }

  std::string text() const { return std::string(edp::describe(input.fault_detail).view()); }

  std::unique_ptr<UrHardware> hardware;
  edp::HardwareInput input;
  JointVector set = JointVector::Zero(6), rate = JointVector::Zero(6);
  Tick now = 0;
  bool enabled = false;

 private:
  using Period = ControllerServers::Period;
  const std::unique_ptr<Controller> controller_;
  SixJoints model_;
  std::atomic<bool> end_{false}, unanswered_{false};
  std::thread thread_;
};

class LockstepInBothInterfaces : public testing::TestWithParam<Interface> {};

/// Joints at the end of a motion, and the ticks that the start takes.
std::pair<Six, int> move(Interface interface) {
  LockstepRig rig(interface);
  const int ticks = rig.start();
  rig.rate << 20, -10, 0, 5, 0, -30;  // of the shafts, rad/s
  for (int i = 0; i < 200; ++i) rig.tick();
  EXPECT_EQ(rig.input.fault, ErrorCode::none) << rig.text();
  EXPECT_EQ(rig.input.time, static_cast<double>(rig.now - 1));
  return {rig.joints(), ticks};
}

TEST_P(LockstepInBothInterfaces, TwoRunsAreEqualToTheLastBit) {
  const auto first = move(GetParam());
  EXPECT_GT(first.first[0], 0.04);
  EXPECT_LT(first.first[5], -0.06);
  EXPECT_GT(first.second, 100) << "power and brakes take 0.1 s each";
  EXPECT_LT(first.second, 200);
  EXPECT_EQ(move(GetParam()), first);
}

INSTANTIATE_TEST_SUITE_P(UrLockstep, LockstepInBothInterfaces,
                         testing::Values(Interface::position, Interface::velocity));

TEST(UrLockstep, TheDeploymentKeepsTheTime) {
  const LockstepRig rig;
  EXPECT_EQ(rig.hardware->clock(), nullptr);
}

TEST(UrLockstep, PackagesMayBeRarerThanTicks) {
  LockstepRig rig(Interface::position, 125);
  ASSERT_GT(rig.start(), 0);
  rig.rate[0] = 20;
  for (int i = 0; i < 102; ++i) rig.tick();
  EXPECT_EQ(rig.input.fault, ErrorCode::none) << rig.text();
  EXPECT_EQ(rig.input.time, static_cast<double>((rig.now - 1) / 4 * 4));
  EXPECT_GT(rig.joints()[0], 0.02);
}

TEST(UrLockstep, RecoversInTheSameNumberOfTicks) {
  int ticks[2];
  for (int& each : ticks) {
    LockstepRig rig;
    ASSERT_GT(rig.start(), 0);
    rig.tick([](VirtualController& controller) { controller.protective_stop(); });
    rig.tick();
    rig.tick();
    EXPECT_EQ(rig.input.fault, ErrorCode::drive_fault);
    rig.enabled = false;
    rig.hardware->reset_fault();
    each = rig.ticks_while_busy();
    EXPECT_EQ(rig.input.fault, ErrorCode::none) << rig.text();
    EXPECT_GT(rig.start(), 0);
    EXPECT_EQ(rig.input.fault, ErrorCode::none) << rig.text();
  }
  EXPECT_EQ(ticks[0], ticks[1]);
  EXPECT_GT(ticks[0], 100) << "the controller releases a protective stop after 0.2 s";
}

TEST(UrLockstep, AStandInThatEndsIsASilentControllerAtOnce) {
  LockstepRig rig;
  ASSERT_GT(rig.start(), 0);
  rig.cut();
  const std::int64_t begin = clock::monotonic_ns();
  for (int i = 0; i < 3; ++i) rig.tick();
  EXPECT_EQ(rig.input.fault, ErrorCode::hardware_silent);
  EXPECT_THAT(rig.text(), HasSubstr("has closed the connection"));
  EXPECT_LT(clock::monotonic_ns() - begin, 5 * clock::kSecond);
  rig.hardware->enable(false);
  rig.hardware->reset_fault();
  EXPECT_EQ(rig.ticks_while_busy(), 1) << "nothing is awaited from it";
  EXPECT_EQ(rig.input.fault, ErrorCode::hardware_silent);
}

TEST(UrLockstep, AStandInThatDoesNotAnswerIsASilentControllerUntilTheEnd) {
  Controller controller(lockstep_options());
  UrOptions options = controller.driver_options();
  options.lockstep = true;
  const SixJoints model(Interface::position);
  UrHardware hardware(options, model, kPeriod);
  hardware.open();
  std::thread first([&] { controller.servers.advance(60 * clock::kSecond); });
  edp::HardwareInput input;
  hardware.read(0, input);
  hardware.write(0, JointVector::Zero(6));
  first.join();
  EXPECT_EQ(input.fault, ErrorCode::none);
  hardware.read(1, input);  // no period has begun
  EXPECT_EQ(input.fault, ErrorCode::hardware_silent);
  EXPECT_THAT(std::string(edp::describe(input.fault_detail).view()), HasSubstr("within 10 s of wall time"));
  const std::int64_t begin = clock::monotonic_ns();
  hardware.read(2, input);
  EXPECT_EQ(input.fault, ErrorCode::hardware_silent);
  EXPECT_LT(clock::monotonic_ns() - begin, 5 * clock::kSecond);
}

}  // namespace
}  // namespace mrroc::ur::lockstep_test
