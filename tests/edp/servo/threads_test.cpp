#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>
#include <thread>

#include "edp/rig.hpp"

namespace mrroc::edp::threads_test {
namespace {

// The servo and the comms side in two threads, both as fast as possible: commands arrive in time, late, and in the same
// tick in which the robot begins to brake.
TEST(ServoChannel, TwoThreadsLoseNoCommandAndNeverTearASetPoint) {
  const Slide model;
  FaultyHardware hardware(model, kPeriod);
  ServoChannel hand_over;
  const ModelSet models(model);
  Servo servo(models, hardware, kPeriod, hand_over);
  Effector effector(models, kPeriod, hand_over);
  effector.enable(true);

  std::atomic<bool> done{false};
  std::uint64_t violations = 0, ticks = 0;
  std::thread servo_thread([&] {
    double previous = 0;
    bool enabled = false;
    for (Tick tick = 0; !done.load(std::memory_order_acquire); ++tick, ++ticks) {
      servo.tick(tick);
      const Snapshot& seen = servo.snapshot();
      const double way = seen.desired.position[0] - previous;
      if (enabled && !(std::abs(way) <= 0.8 * kPeriod * (1 + 1e-6))) ++violations;
      if (seen.fault.code != ErrorCode::none) ++violations;
      previous = seen.desired.position[0];
      enabled = seen.enabled();
      if (tick % 4 == 0) std::this_thread::yield();
    }
  });

  std::mt19937 random(1);
  std::uint64_t accepted = 0, replied = 0, refused = 0;
  Tick newest = 0;
  RobotState state;
  while (!effector.peek(state) || !state.enabled) std::this_thread::yield();
  for (std::uint64_t number = 1; number <= 3000; ++number) {
    ASSERT_TRUE(effector.peek(state));
    EXPECT_GE(state.tick, newest);
    newest = state.tick;
    // back and forth, mostly ending in motion
    RobotCommand command = joint_command(one(number % 2 == 0 ? 0.02 : -0.02), 60, 1);
    command.reply_step = static_cast<std::uint16_t>(1 + random() % 61);
    if (number % 5 != 0) {
      command.relative = true;
      command.joint_velocity = one(number % 2 == 0 ? 0.1 : -0.1);
      command.joint_acceleration = one(0);
    }
    Reply reply;
    if (effector.accept(command, number, reply)) {
      ++refused;
      EXPECT_EQ(reply.command, number);
    } else {
      ++accepted;
      while (!effector.poll(reply)) std::this_thread::yield();
      EXPECT_EQ(reply.command, number);
      if (reply.state.error.error_class == ErrorClass::none)
        ++replied;
      else
        ++refused;
    }
    for (unsigned i = random() % 8; i > 0; --i) std::this_thread::yield();
  }
  done.store(true, std::memory_order_release);
  servo_thread.join();
  EXPECT_EQ(violations, 0u);
  EXPECT_EQ(replied + refused, 3000u);
  EXPECT_GT(replied, 1000u);
  EXPECT_GT(servo.snapshot().counters.stops, 10u);
  RecordProperty("late", static_cast<int>(effector.counters().late));
}

}  // namespace
}  // namespace mrroc::edp::threads_test
