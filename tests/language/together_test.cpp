#include "mrroc/generators/together.hpp"

#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/move.hpp"

namespace mrroc::together_test {
namespace {

using fakes::check_property;
using fakes::FakeTask;
using fakes::pick;

/// Moves its robot by joints for `steps` steps; counts its calls.
class Stepping : public Generator {
 public:
  Stepping(Robot& robot, int steps) : Generator("Stepping"), robot_(&robot), left_(steps) {}
  void start() override { ++starts; }
  void resume() override { ++resumes; }
  bool terminal_condition() override { return ++asked, left_ == 0; }
  void next_state() override {
    ++commands;
    if (left_ > 0) --left_;
    robot_->command().kind = CommandKind::joint;
    robot_->command().joints = robot_->state().desired_joints;
  }
  int starts = 0, resumes = 0, asked = 0, commands = 0;

 private:
  Robot* robot_;
  int left_;
};

std::vector<CommandKind> sent_to(const FakeTask& task, const std::string& robot) {
  std::vector<CommandKind> kinds;
  for (const fakes::Call& call : task.log.calls) {
    if (call.action == fakes::Action::send && call.device == robot && call.kind != CommandKind::query)
      kinds.push_back(call.kind);
  }
  return kinds;
}

TEST(Together, LastsAsLongAsItsLongestPartAndRobotsOfEndedPartsHold) {
  check_property(300, [] {
    FakeTask task;
    const auto a = task.robot("a"), b = task.robot("b"), c = task.robot("c");
    const std::array<int, 3> steps{pick(0, 20), pick(0, 20), pick(0, 20)};
    Stepping first(*a, steps[0]), second(*b, steps[1]), third(*c, steps[2]);
    const Outcome end = Move({*a, *b, *c}, {}, Together(first, second, third));
    const int longest = *std::max_element(steps.begin(), steps.end());
    RC_ASSERT(end.ending == Ending::generator);
    RC_ASSERT(end.steps == static_cast<std::uint64_t>(longest));
    const std::array<const Stepping*, 3> parts{&first, &second, &third};
    const std::array<const char*, 3> robots{"a", "b", "c"};
    for (std::size_t i = 0; i < 3; ++i) {
      RC_ASSERT(parts[i]->starts == 1);
      RC_ASSERT(parts[i]->commands == steps[i]);
      RC_ASSERT(parts[i]->asked == steps[i] + 1);  // once a step, and not again after its end
      const auto kinds = sent_to(task, robots[i]);
      for (int k = 0; k < longest; ++k)
        RC_ASSERT(kinds[static_cast<std::size_t>(k)] == (k < steps[i] ? CommandKind::joint : CommandKind::hold));
    }
  });
}

TEST(Together, PartEndsByItsOwnConditionAndAllByTheCommonOne) {
  FakeTask task;
  const auto a = task.robot("a"), b = task.robot("b");
  Stepping first(*a, 1000), second(*b, 9);
  EXPECT_EQ(Move({*a, *b}, {}, Together(first.until(ElapsedSteps{4}), second)).steps, 9u);
  EXPECT_EQ(first.commands, 4);
  Stepping third(*a, 1000), fourth(*b, 1000);
  const Outcome end = Move({*a, *b}, {}, Together(third, fourth).until(ElapsedSteps{7}));
  EXPECT_EQ(end.steps, 7u);
  EXPECT_TRUE(end.by<ElapsedSteps>());
}

TEST(Together, OnlyRunningPartsContinueAfterAPause) {
  FakeTask task;
  const auto a = task.robot("a"), b = task.robot("b");
  Stepping first(*a, 2), second(*b, 20);
  task.requests.assign(6, OperatorRequest::none);
  task.requests.insert(task.requests.end(), 3, OperatorRequest::pause);
  Move({*a, *b}, {}, Together(first, second));
  EXPECT_EQ(first.resumes, 0);
  EXPECT_EQ(second.resumes, 1);
  EXPECT_EQ(first.commands, 2);
  EXPECT_EQ(second.commands, 20);
}

TEST(Together, OwnsTemporariesAndCanRunAgain) {
  FakeTask task;
  const auto a = task.robot("a"), b = task.robot("b");
  Together both{JointLine{*a, JointVector::Constant(6, 0.2)}, Hold{*b, 0.1}};
  EXPECT_EQ(both.name(), "JointLine + Hold");
  EXPECT_EQ(Move({*a, *b}, {}, both).ending, Ending::generator);
  EXPECT_NEAR(a->state().desired_joints[0], 0.2, 1e-12);
  Move({*a, *b}, {}, JointLine{*a, JointVector::Zero(6)});
  EXPECT_EQ(Move({*a, *b}, {}, both).ending, Ending::generator);
  EXPECT_NEAR(a->state().desired_joints[0], 0.2, 1e-12);
}

}  // namespace
}  // namespace mrroc::together_test
