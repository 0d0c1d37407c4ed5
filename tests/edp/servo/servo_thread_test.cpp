#include "edp/servo/servo_thread.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "clock/wall/monotonic.hpp"
#include "edp/rig.hpp"

namespace mrroc::edp::servo_thread_test {
namespace {

/// A grid that starts now, and a count of the wake-ups.
class GridClock : public clock::Clock {
 public:
  double period() const noexcept override { return 0.0005; }
  Tick tick() const noexcept override { return 0; }
  bool simulated() const noexcept override { return false; }
  std::int64_t epoch_ns() const noexcept override { return epoch_; }
  double wall_seconds() const noexcept override { return 0; }
  bool start() override { return true; }
  clock::Wake wait(Tick) override { return clock::Wake::tick; }
  void interrupt() noexcept override {}
  void notify() noexcept override { notified.fetch_add(1); }
  clock::EmergencyStop& emergency_stop() noexcept override { return emergency_stop_; }
  clock::GroupStops& group_stops() noexcept override { return group_stops_; }
  int register_sender(std::string_view) override { return 0; }
  int register_receiver(std::string_view) override { return 0; }
  std::uint64_t delta() const noexcept override { return 0; }
  bool visible(std::uint64_t) const noexcept override { return true; }
  void sent(int) noexcept override {}
  void arrived(int) noexcept override {}

  std::atomic<int> notified{0};

 private:
  std::int64_t epoch_ = clock::monotonic_ns();
  clock::EmergencyStop emergency_stop_;
  clock::GroupStops group_stops_;
};

TEST(ServoThread, TicksTheServoWakesTheCommsSideAndEndsWithTheRobotAtRestAndTheDrivesOff) {
  Slide model;
  model.change().axes[0].following_error_max = 1e9;  // a loaded machine may miss ticks
  GridClock clock;
  FaultyHardware hardware(model, clock.period());
  ServoChannel hand_over;
  const ModelSet models(model);
  Servo servo(models, hardware, clock.period(), hand_over);
  Effector effector(models, clock.period(), hand_over);
  effector.enable(true);
  {
    ServoThread thread(servo, clock);
    RobotState state;
    while (!effector.peek(state) || !state.enabled) std::this_thread::yield();
    RobotCommand command = joint_command(one(0.4), 1000, 800);
    command.joint_velocity = one(0.3);
    Reply reply;
    ASSERT_FALSE(effector.accept(command, 1, reply)) << reply.state.error.detail.view();
    const int before = clock.notified;  // by switching on
    while (clock.notified == before) std::this_thread::yield();
    ASSERT_TRUE(effector.poll(reply));
    EXPECT_EQ(reply.state.error.code, ErrorCode::none);
    EXPECT_GT(thread.statistics().ticks(), 0u);
  }
  EXPECT_FALSE(hardware.powered);
  EXPECT_FALSE(servo.drives_on());
  EXPECT_TRUE(servo.snapshot().desired.at_rest());
  EXPECT_GT(servo.snapshot().desired.position[0], 0.3);
}

/// Drives that occasionally overrun three periods, and record the ticks of their calls.
class OverrunningHardware : public LoopbackHardware {
 public:
  OverrunningHardware(const RobotModel& model, double period, bool waits)
      : LoopbackHardware(model, period), waits_(waits), period_ns_(std::llround(period * 1e9)) {
    asked.reserve(100000);
  }
  bool waits() const noexcept override { return waits_; }
  void read(Tick tick, HardwareInput& input) noexcept override {
    if (asked.size() < asked.capacity()) asked.push_back(tick);
    const std::int64_t end = clock::monotonic_ns() + 3 * period_ns_;
    while (asked.size() % 20 == 10 && clock::monotonic_ns() < end) {
    }
    overruns.fetch_add(asked.size() % 20 == 10 ? 1 : 0);
    LoopbackHardware::read(tick, input);
  }
  std::vector<Tick> asked;
  std::atomic<int> overruns{0};

 private:
  bool waits_;
  std::int64_t period_ns_;
};

TEST(ServoThread, WaitingDrivesGetEveryTickOthersThePresentOne) {
  for (const bool waits : {true, false}) {
    Slide model;
    GridClock clock;
    OverrunningHardware hardware(model, clock.period(), waits);
    ServoChannel hand_over;
    const ModelSet models(model);
    Servo servo(models, hardware, clock.period(), hand_over);
    {
      ServoThread thread(servo, clock);
      while (hardware.overruns < 5) std::this_thread::yield();
      EXPECT_GE(thread.statistics().missed(), 5u)
          << "two of three periods are lost entirely in each but the last overrun";
    }
    std::uint64_t skipped = 0;
    for (std::size_t i = 1; i < hardware.asked.size(); ++i) {
      ASSERT_GT(hardware.asked[i], hardware.asked[i - 1]);
      skipped += hardware.asked[i] - hardware.asked[i - 1] - 1;
    }
    EXPECT_EQ(servo.snapshot().counters.missed, skipped);
    if (waits)
      EXPECT_EQ(skipped, 0u);
    else
      EXPECT_GE(skipped, 5u);
  }
}

}  // namespace
}  // namespace mrroc::edp::servo_thread_test
