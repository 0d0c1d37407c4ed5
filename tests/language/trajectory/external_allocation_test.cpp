// A robot that is yielded: its steps allocate nothing, also when trajectories come, replace each other and end.
#include <gtest/gtest.h>

#include "allocations.hpp"
#include "language/fakes.hpp"
#include "mrroc/generators/external.hpp"
#include "mrroc/joint_trajectory.hpp"
#include "mrroc/move.hpp"
#include "mrroc/trajectory_link.hpp"

namespace mrroc::fakes::external_allocation_test {
namespace {

constexpr std::uint64_t kSteps = 700;

/// Parts that are made before the Move.
class PreparedLink : public TrajectoryLink {
 public:
  bool take(const FixedText<kNameLength>&, TrajectoryPart& part) override {
    if (next == parts.size() || steps < parts[next].begin_at) return false;
    part = parts[next++].part;
    return true;
  }
  void report(const TrajectoryReport& report) override { arrived += report.state == TrajectoryState::arrived ? 1 : 0; }

  void prepare(std::uint64_t at, std::uint64_t number, double way) {
    JointTrajectory trajectory(6, JointTrajectory::Order::positions, 200);
    for (std::size_t i = 0; i < 200; ++i) {
      const double s = (static_cast<double>(i) + 1) / 200;
      const std::vector<double> joints(6, way * s * s * (3 - 2 * s));
      trajectory.set_point(i, 1 + 3 * s, joints);  // a second for the way to its beginning
    }
    const auto numbers = trajectory.numbers();
    for (std::size_t begin = 0; begin < numbers.size(); begin += TrajectoryPart::kNumbers) {
      Timed timed{at, {}};
      timed.part.trajectory = number;
      timed.part.size = static_cast<std::uint32_t>(numbers.size());
      timed.part.begin = static_cast<std::uint32_t>(begin);
      timed.part.count = static_cast<std::uint16_t>(std::min(TrajectoryPart::kNumbers, numbers.size() - begin));
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(begin), timed.part.count, timed.part.numbers.begin());
      parts.push_back(timed);
    }
  }

  struct Timed {
    std::uint64_t begin_at;
    TrajectoryPart part;
  };
  std::vector<Timed> parts;
  std::size_t next = 0;
  std::uint64_t steps = 0;
  int arrived = 0;
};

class PreparedTask : public FakeTask, public StepObserver {
 public:
  PreparedTask() { step_observer = this; }
  TrajectoryLink* trajectory_link() noexcept override { return &link; }
  void on_step(const StepRecord&) noexcept override {
    if (++link.steps == 2) first = test::allocations();
    total = test::allocations() - first;
  }
  PreparedLink link;
  std::uint64_t first = 0, total = 0;
};

TEST(ExternalAllocation, StepsDoNotAllocate) {
  PreparedTask task;
  const auto arm = task.robot("arm");
  task.log.recording = false;
  task.link.prepare(5, 1, 0.2);
  task.link.prepare(90, 2, 0.1);
  task.link.prepare(350, 3, 0.0);
  Move({*arm}, {}, External{*arm}.until(When{"over", [&] { return task.link.steps > kSteps; }}));
  EXPECT_GE(task.link.steps, kSteps);
  EXPECT_EQ(task.link.arrived, 2);
  EXPECT_EQ(task.total, 0U);
}

}  // namespace
}  // namespace mrroc::fakes::external_allocation_test
