#include "edp/servo/servo_tap.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

#include "allocations.hpp"
#include "edp/rig.hpp"

namespace mrroc::edp::servo_tap_test {
namespace {

TEST(ServoTap, HasEveryTickOfAMotionAndAllocatesNothing) {
  Rig<Slide> rig;
  ServoTap reader = ServoTap::create(kServoTapName, kServoTapWhat);
  ServoTap tap = ServoTap::attach(reader.fd(), kServoTapWhat);
  rig.servo.use_tap(tap, false);
  ASSERT_FALSE(rig.send(joint_command(one(0.5), 700, 700)));
  rig.replies.reserve(10);
  const Tick first = rig.now;
  {
    const test::Counting scope;
    rig.run(1000);
  }
  EXPECT_EQ(test::Counting::counted(), 0u);
  JointVector desired;
  ASSERT_EQ(rig.model.joints_to_motors(one(0.5), desired), ErrorCode::none);
  double fastest = 0, before = 0;
  for (Tick tick = first; tick < first + 1000; ++tick) {
    const ServoSample* const sample = reader.front();
    ASSERT_NE(sample, nullptr);
    EXPECT_EQ(sample->tick, tick);
    EXPECT_EQ(sample->ahead, 0);
    EXPECT_EQ(sample->measured, static_cast<double>(tick));
    EXPECT_EQ(sample->state, ServoState::on);
    EXPECT_EQ(sample->axes, 1u);
    EXPECT_EQ(sample->fault, ErrorCode::none);
    if (tick > first) fastest = std::max(fastest, std::abs(sample->desired_motors[0] - before));
    before = sample->desired_motors[0];
    reader.pop();
  }
  EXPECT_EQ(reader.front(), nullptr);
  EXPECT_EQ(before, desired[0]);
  EXPECT_GT(fastest, 0);
  EXPECT_EQ(reader.dropped(), 0u);
}

TEST(ServoTap, ARecorderThatHangsLosesTheNewestSamplesWhichAreCounted) {
  Rig<Slide> rig;
  ServoTap reader = ServoTap::create(kServoTapName, kServoTapWhat);
  ServoTap tap = ServoTap::attach(reader.fd(), kServoTapWhat);
  rig.servo.use_tap(tap, false);
  const Tick first = rig.now;
  rig.run(ServoTap::kCapacity + 37);
  EXPECT_EQ(reader.dropped(), 37u);
  for (Tick tick = first; tick < first + ServoTap::kCapacity; ++tick) {
    ASSERT_EQ(reader.front()->tick, tick);
    reader.pop();
  }
  rig.tick();
  EXPECT_EQ(reader.front()->tick, rig.now - 1) << "it continues";
}

TEST(ServoTap, AnotherThreadReadsSamplesWholeAndInOrder) {
  Rig<Slide> rig;
  ServoTap reader = ServoTap::create(kServoTapName, kServoTapWhat);
  ServoTap tap = ServoTap::attach(reader.fd(), kServoTapWhat);
  rig.servo.use_tap(tap, false);
  constexpr std::uint64_t kTicks = 20000;
  std::uint64_t seen = 0, disorder = 0;
  std::atomic<bool> end{false};
  std::thread recorder([&] {
    Tick last = 0;
    for (;;) {
      const bool ending = end.load();
      while (const ServoSample* const sample = reader.front()) {
        if (sample->tick <= last || sample->measured != static_cast<double>(sample->tick)) ++disorder;
        last = sample->tick;
        ++seen;
        reader.pop();
      }
      if (ending) return;
    }
  });
  rig.run(kTicks);
  end = true;
  recorder.join();
  EXPECT_EQ(disorder, 0u);
  EXPECT_EQ(seen + reader.dropped(), kTicks);
}

TEST(ServoTap, OfASimulatedClockLosesNothingToASlowRecorder) {
  Rig<Slide> rig;
  ServoTap reader = ServoTap::create(kServoTapName, kServoTapWhat);
  ServoTap tap = ServoTap::attach(reader.fd(), kServoTapWhat);
  rig.servo.use_tap(tap, true);
  constexpr std::uint64_t kTicks = 3 * ServoTap::kCapacity;
  const Tick first = rig.now;
  std::thread servo([&] {
    rig.run(kTicks);
    tap.end();
  });
  for (Tick tick = first; tick < first + kTicks;) {
    const ServoSample* const sample = reader.front();
    if (sample == nullptr) continue;
    EXPECT_EQ(sample->tick, tick);
    reader.pop();
    ++tick;
    if (tick % ServoTap::kCapacity == 0) usleep(20'000);  // the ring is full meanwhile
  }
  servo.join();
  EXPECT_EQ(reader.dropped(), 0u);
  EXPECT_EQ(reader.added(), kTicks);
  EXPECT_TRUE(reader.ended());
}

}  // namespace
}  // namespace mrroc::edp::servo_tap_test
