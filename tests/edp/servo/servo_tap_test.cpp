#include "edp/servo/servo_tap.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "allocations.hpp"
#include "edp/rig.hpp"

namespace mrroc::edp {
namespace {

TEST(ServoTap, HasEveryTickOfAMotionAndAllocatesNothing) {
  Rig<Slide> rig;
  ServoTap tap;
  rig.servo.use_tap(tap);
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
    const ServoSample* const sample = tap.front();
    ASSERT_NE(sample, nullptr);
    EXPECT_EQ(sample->tick, tick);
    EXPECT_EQ(sample->ahead, 0);
    EXPECT_EQ(sample->measured, static_cast<double>(tick));
    EXPECT_EQ(sample->state, ServoState::on);
    EXPECT_EQ(sample->motors.size(), 1);
    if (tick > first) fastest = std::max(fastest, std::abs(sample->set_point[0] - before));
    before = sample->set_point[0];
    tap.pop();
  }
  EXPECT_EQ(tap.front(), nullptr);
  EXPECT_EQ(before, desired[0]);
  EXPECT_GT(fastest, 0);
  EXPECT_EQ(tap.dropped(), 0u);
}

TEST(ServoTap, ARecorderThatHangsLosesTheNewestSamplesWhichAreCounted) {
  Rig<Slide> rig;
  ServoTap tap;
  rig.servo.use_tap(tap);
  const Tick first = rig.now;
  rig.run(ServoTap::kCapacity + 37);
  EXPECT_EQ(tap.dropped(), 37u);
  for (Tick tick = first; tick < first + ServoTap::kCapacity; ++tick) {
    ASSERT_EQ(tap.front()->tick, tick);
    tap.pop();
  }
  rig.tick();
  EXPECT_EQ(tap.front()->tick, rig.now - 1) << "it continues";
}

TEST(ServoTap, AnotherThreadReadsSamplesWholeAndInOrder) {
  Rig<Slide> rig;
  ServoTap tap;
  rig.servo.use_tap(tap);
  constexpr std::uint64_t kTicks = 20000;
  std::uint64_t seen = 0, disorder = 0;
  std::atomic<bool> end{false};
  std::thread recorder([&] {
    Tick last = 0;
    for (;;) {
      const bool ending = end.load();
      while (const ServoSample* const sample = tap.front()) {
        if (sample->tick <= last || sample->measured != static_cast<double>(sample->tick)) ++disorder;
        last = sample->tick;
        ++seen;
        tap.pop();
      }
      if (ending) return;
    }
  });
  rig.run(kTicks);
  end = true;
  recorder.join();
  EXPECT_EQ(disorder, 0u);
  EXPECT_EQ(seen + tap.dropped(), kTicks);
}

}  // namespace
}  // namespace mrroc::edp
