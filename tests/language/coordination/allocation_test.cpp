// A step in which the MP takes part, and a step towards a target, allocate nothing.
#include <gtest/gtest.h>

#include "allocations.hpp"
#include "language/coordination/fake_mp.hpp"
#include "language/fakes.hpp"
#include "mrroc/generators/complying.hpp"
#include "mrroc/generators/corrected.hpp"
#include "mrroc/move.hpp"
#include "mrroc/tracker.hpp"

namespace mrroc::fakes::allocation_test {
namespace {

constexpr std::size_t kSteps = 200;

/// Allocations from the second step on.
class Counter : public StepObserver {
 public:
  void on_step(const StepRecord&) noexcept override {
    if (++steps == 2) first_ = test::allocations();
    total = test::allocations() - first_;
  }
  std::uint64_t steps = 0, total = 0;

 private:
  std::uint64_t first_ = 0;
};

/// A Move with a generator made by `make`, over an MP that moves the arm and its wrench.
template <class Make>
Counter run(Make make) {
  FakeTask task;
  FakeMp mp;
  Counter counter;
  const auto arm = task.robot("arm");
  task.log.recording = false;
  mp.items = {item(CommandKind::query)};
  mp.items.reserve(2 * kSteps);
  mp.replies.reserve(2 * kSteps);
  FakeRobotLink& fake = task.robot_fake("arm");
  mp.make = [&fake](const std::vector<RobotState>& replies) {
    fake.state.wrench[1] = 3;
    RobotCommand command = item(CommandKind::pose).command;
    command.pose.translation().x() = 1e-4 * static_cast<double>(replies.size());
    return command;
  };
  task.step_observer = &counter;
  Superior superior(mp);
  auto generator = make(superior, *arm);
  generator->until(When{"over", [&] { return mp.replies.size() > kSteps; }});
  Move({*arm}, {}, *generator);
  return counter;
}

TEST(CoordinationAllocation, ComplyingDoesNotAllocate) {
  const Counter counter =
      run([](Superior& superior, Robot& arm) { return std::make_unique<Complying>(superior, arm); });
  EXPECT_GE(counter.steps, kSteps);
  EXPECT_EQ(counter.total, 0U);
}

TEST(CoordinationAllocation, CorrectedDoesNotAllocate) {
  const Counter counter = run([](Superior& superior, Robot& arm) {
    return std::make_unique<Corrected>(superior, arm, [] { return Pose{Eigen::Translation3d(0, 0.003, 0)}; });
  });
  EXPECT_GE(counter.steps, kSteps);
  EXPECT_EQ(counter.total, 0U);
}

class Follow : public Generator {
 public:
  explicit Follow(Robot& robot) : Generator("Follow"), tracker_(robot) {}
  void next_state() override {
    ++steps_;
    if (steps_ % 60 < 30) return tracker_.to(JointVector::Constant(6, steps_ % 40 < 20 ? 0.5 : -0.5));
    Pose pose = Pose::Identity();
    pose.translation().x() = 0.1;
    tracker_.to(pose);
  }

 private:
  Tracker tracker_;
  int steps_ = 0;
};

TEST(CoordinationAllocation, TrackerDoesNotAllocate) {
  FakeTask task;
  Counter counter;
  const auto arm = task.robot("arm");
  task.log.recording = false;
  task.step_observer = &counter;
  Follow follow(*arm);
  Move({*arm}, {}, follow.until(ElapsedSteps{kSteps}));
  EXPECT_GE(counter.steps, kSteps);
  EXPECT_EQ(counter.total, 0U);
}

}  // namespace
}  // namespace mrroc::fakes::allocation_test
