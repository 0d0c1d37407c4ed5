#include "mrroc/generators/teach_in.hpp"

#include <limits>

#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/move.hpp"

namespace mrroc::teach_in_test {
namespace {

using fakes::check_property;
using fakes::FakeTask;
using fakes::pick;

/// Moves every axis by 0.001 a step.
class Creep : public Generator {
 public:
  explicit Creep(Robot& robot) : Generator("creep"), robot_(robot) {}
  void next_state() override {
    robot_.command().kind = CommandKind::joint;
    robot_.command().joints = robot_.state().desired_joints.array() + 0.001;
  }

 private:
  Robot& robot_;
};

TEST(TeachIn, RecordsThePathOfAnotherGeneratorAtItsInterval) {
  check_property(200, [] {
    FakeTask task;
    const auto arm = task.robot("arm");
    const auto n = static_cast<std::uint16_t>(pick(1, 20));
    arm->set_macrostep(n, static_cast<std::uint16_t>(pick(1, n)));
    const double step = arm->step_duration(), interval = 0.001 * pick(1, 300);
    const int steps = pick(1, 200);
    TaughtPath path;
    path.points.resize(7);  // of an earlier recording
    Move({*arm}, {},
         Together{Creep{*arm}, TeachIn{*arm, path, interval}}.until(ElapsedSteps{static_cast<std::uint64_t>(steps)}));
    RC_ASSERT(path.timed);
    RC_ASSERT(!path.points.empty());
    // the first state is at rest, so the first step may begin later
    const double first = path.points.front().time;
    RC_ASSERT(first == 0.0);
    const double whole = steps * step;
    RC_ASSERT(path.points.size() >= static_cast<std::size_t>(whole / (interval + step)));
    RC_ASSERT(path.points.size() <= static_cast<std::size_t>(whole / std::max(interval, step) + 1.0 + 1e-6));
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const TaughtPoint& point = path.points[i];
      if (i > 0) RC_ASSERT(point.time > path.points[i - 1].time);
      const double taken = point.joints[0] / 0.001;  // number of steps
      RC_ASSERT(std::abs(point.time - taken * step) < 1e-9);
      RC_ASSERT(std::abs(point.pose.translation().x() - point.joints[0]) < 1e-12);
    }
  });
}

TEST(TeachIn, AloneItHoldsTheRobotAndAddsAPointForEachTrigger) {
  FakeTask task;
  const auto arm = task.robot("arm");
  TaughtPath path;
  path.points.resize(1);  // taught before
  task.triggers = 3;      // from before the instruction
  int step = 0;
  const auto ends = [&] {
    ++step;
    if (step == 4 || step == 9) task.triggers = 1;
    return step > 12;
  };
  task.robot_fake("arm").state.desired_joints.setConstant(0.25);
  Move({*arm}, {}, TeachIn{*arm, path}.until(When{"over", ends}));
  ASSERT_EQ(path.points.size(), 3u);
  EXPECT_FALSE(path.timed);
  EXPECT_EQ(path.points[1].joints, JointVector::Constant(6, 0.25));
  for (const auto& call : task.log.calls) EXPECT_NE(call.kind, CommandKind::joint);
}

TEST(TeachIn, PauseIsNotPartOfTheTime) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.requests.assign(10, OperatorRequest::none);
  task.requests.insert(task.requests.end(), 40, OperatorRequest::pause);
  TaughtPath path;
  Move({*arm}, {}, Together{Creep{*arm}, TeachIn{*arm, path, arm->step_duration()}}.until(ElapsedSteps{30}));
  ASSERT_GE(path.points.size(), 30u);
  EXPECT_LE(path.points.back().time, 31 * arm->step_duration());
  for (std::size_t i = 1; i < path.points.size(); ++i) EXPECT_GT(path.points[i].time, path.points[i - 1].time);
}

TEST(TeachIn, FullPathIsAnError) {
  FakeTask task;
  const auto arm = task.robot("arm");
  TaughtPath path;
  try {
    Move({*arm}, {}, Together{Creep{*arm}, TeachIn{*arm, path, 0.02, 5}}.until(ElapsedSteps{100}));
    FAIL() << "no error";
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::resources);
    EXPECT_EQ(path.points.size(), 5u);
  }
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW((TeachIn{*arm, path, bad}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::teach_in_test
