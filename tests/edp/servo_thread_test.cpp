#include "edp/servo_thread.hpp"

#include <gtest/gtest.h>

#include "clock/monotonic.hpp"
#include "rig.hpp"

namespace mrroc::edp {
namespace {

/// A grid that begins now, and a count of the wake-ups.
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
  int register_sender(std::string_view) override { return 0; }
  int register_receiver(std::string_view) override { return 0; }
  std::uint64_t delta() const noexcept override { return 0; }
  bool visible(std::uint64_t) const noexcept override { return true; }
  void sent(int) noexcept override {}
  void arrived(int) noexcept override {}

  std::atomic<int> notified{0};

 private:
  std::int64_t epoch_ = clock::monotonic_ns();
};

TEST(ServoThread, TicksTheServoWakesTheCommsSideAndEndsWithTheRobotAtRestAndTheDrivesOff) {
  Slide model;
  model.change().axes[0].following_error_max = 1e9;  // a loaded machine may miss ticks
  GridClock clock;
  FaultyHardware hardware(model, clock.period());
  HandOver hand_over;
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
    const int before = clock.notified;  // of switching on
    while (clock.notified == before) std::this_thread::yield();
    ASSERT_TRUE(effector.poll(reply));
    EXPECT_EQ(reply.state.error.code, ErrorCode::none);
    EXPECT_GT(thread.ticker().ticks(), 0u);
  }
  EXPECT_FALSE(hardware.powered);
  EXPECT_FALSE(servo.drives_on());
  EXPECT_TRUE(servo.snapshot().desired.at_rest());
  EXPECT_GT(servo.snapshot().desired.position[0], 0.3);
}

}  // namespace
}  // namespace mrroc::edp
