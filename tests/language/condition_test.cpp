#include "mrroc/condition.hpp"

#include <functional>
#include <limits>

#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/script_generator.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/operator_trigger.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/move.hpp"

namespace mrroc::condition_test {
namespace {

using fakes::check_property;
using fakes::FakeTask;
using fakes::Script;

/// A generator that moves the first axis by `step` every step.
class Advance : public Generator {
 public:
  Advance(Robot& robot, double step) : Generator("advance"), robot_(robot), step_(step) {}
  void next_state() override {
    robot_.command().kind = CommandKind::joint;
    robot_.command().joints = robot_.state().desired_joints;
    robot_.command().joints[0] += step_;
  }

 private:
  Robot& robot_;
  double step_;
};

TEST(Condition, TreeHasTheValueAndTheReasonsOfItsParts) {
  check_property(2000, [] {
    Script script;
    fakes::add_random_tree(script, 15);
    const std::size_t root = script.nodes.size() - 1;
    const auto condition = fakes::build_condition(script, root, nullptr);
    condition->start();
    std::size_t leaf_count = 0;
    for (const fakes::NodeScript& node : script.nodes) leaf_count += node.kind == fakes::NodeScript::Kind::leaf ? 1 : 0;
    std::vector<const Condition*> leaves;
    condition->append_leaves(leaves);
    RC_ASSERT(leaves.size() == leaf_count);
    for (std::uint64_t k = 0; k < 30; ++k) {
      const bool value = fakes::predict_value(script, root, k);
      RC_ASSERT(condition->evaluate() == value);
      RC_ASSERT(condition->value() == value);
      if (!value) continue;
      Outcome outcome;
      outcome.condition = condition;
      condition->append_reasons(outcome.reasons);
      fakes::Result predicted{};
      fakes::predict_reasons(script, root, k, predicted);
      const fakes::Result result = fakes::result_of(outcome);
      RC_ASSERT(result.reasons == predicted.reasons);
      RC_ASSERT(result.by_red == predicted.by_red);
      RC_ASSERT(result.by_blue == predicted.by_blue);
      std::string text;
      for (const std::string& name : predicted.reasons) {
        RC_ASSERT(outcome.by(name));
        text += (text.empty() ? "" : " and ") + name;
      }
      RC_ASSERT(outcome.reason() == text);
      RC_ASSERT(!outcome.by("nobody"));
    }
  });
}

TEST(Condition, OperatorsBuildTheTree) {
  bool a = false;
  bool b = false;
  auto tree = (When{"a", [&] { return a; }} && !When{"b", [&] { return b; }}) || When{"c", [] { return false; }};
  EXPECT_EQ(tree.name(), "a and not (b) or c");
  EXPECT_FALSE(tree.evaluate());
  a = true;
  EXPECT_TRUE(tree.evaluate());
  b = true;
  EXPECT_FALSE(tree.evaluate());
}

TEST(Condition, NamedCombinationIsFoundByItsNameAndByItsParts) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const Outcome end = Wait({*arm}, {}, named("both sides", ElapsedSteps{2} && When{"yes", [] { return true; }}));
  EXPECT_TRUE(end.by("both sides"));
  EXPECT_TRUE(end.by("yes"));
  EXPECT_TRUE(end.by<ElapsedSteps>());
  EXPECT_FALSE(end.by<Travelled>());
  EXPECT_EQ(end.reason(), "both sides and elapsed 2 steps and yes");
}

TEST(Condition, InstructionWithoutTheRequiredEndThrowsTheTasksReason) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const auto wait = [&] { return Wait({*arm}, {}, named("late", ElapsedSteps{2}) || Travelled{*arm, 1}); };
  EXPECT_EQ(wait().require<ElapsedSteps>("too far").require("late", "too far").steps, 2u);
  const auto refusal = [&](const std::function<void()>& instruction) -> std::string {
    try {
      instruction();
    } catch (const NonFatalError& error) {
      EXPECT_EQ(error.code(), ErrorCode::task_failed);
      return error.detail();
    }
    return "nothing is thrown";
  };
  EXPECT_EQ(refusal([&] { wait().require<Travelled>("no robot moves"); }), "no robot moves");
  EXPECT_EQ(refusal([&] { wait().require("early", "it is late"); }), "it is late");
  const auto generator = [&] { return Move({*arm}, {}, JointLine{*arm, JointVector::Constant(6, 0.1)}); };
  EXPECT_EQ(refusal([&] { generator().require<Travelled>("it has arrived"); }), "it has arrived");
}

TEST(Condition, RepeatedUntilMeansEither) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Advance generator(*arm, 0.01);
  generator.until(ElapsedSteps{9}).until(named("early", ElapsedSteps{4}));
  const Outcome end = Move({*arm}, {}, generator);
  EXPECT_EQ(end.steps, 4u);
  EXPECT_TRUE(end.by("early"));
  EXPECT_FALSE(end.by("elapsed 9 steps"));
}

TEST(Condition, ElapsedStepsEndsAfterThatManyStepsEveryTime) {
  FakeTask task;
  const auto arm = task.robot("arm");
  for (const std::uint64_t steps : {0u, 1u, 7u}) {
    ElapsedSteps condition(steps);
    EXPECT_EQ(Wait({*arm}, {}, condition).steps, steps);
    Advance generator(*arm, 0);
    generator.until(condition);
    EXPECT_EQ(Move({*arm}, {}, generator).steps, steps);
    EXPECT_EQ(Move({*arm}, {}, generator).steps, steps);  // it starts again
  }
}

TEST(Condition, TravelledHoldsFromTheDistanceOn) {
  check_property(500, [] {
    FakeTask task;
    const auto arm = task.robot("arm");
    const double step = 0.001 * fakes::pick(1, 20);
    const double distance = 0.001 * fakes::pick(1, 200);
    Advance generator(*arm, step);
    generator.until(Travelled{*arm, distance});
    task.robot_fake("arm").state.pose.translation() << 0.3, -0.2, 0.1;  // away from the origin of its base
    task.robot_fake("arm").state.desired_joints.head<3>() << 0.3, -0.2, 0.1;
    const double before = 0.3;
    const Outcome end = Move({*arm}, {}, generator);
    const double travelled = arm->state().pose.translation().x() - before;
    RC_ASSERT(end.by<Travelled>());
    RC_ASSERT(travelled > distance - 1e-9);
    RC_ASSERT(travelled < distance + step);
  });
}

TEST(Condition, TravelledRefusesInvalidDistances) {
  FakeTask task;
  const auto arm = task.robot("arm");
  EXPECT_EQ((Travelled{*arm, 0.15}.name()), "travelled 0.15 m");
  EXPECT_EQ((Travelled{*arm, 100}.name()), "travelled 100 m");
  for (const double distance :
       {0.0, -0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((Travelled{*arm, distance}), NonFatalError);
  }
}

TEST(Condition, OperatorTriggerIgnoresOldTriggersAndKeepsNewOnes) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.triggers = 3;
  int evaluations = 0;
  const When later("later", [&] {
    if (++evaluations == 3) task.triggers = 1;  // found at step 2 or 3, depending on the order of the parts
    return evaluations >= 8;
  });
  const Outcome end = Wait({*arm}, {}, OperatorTrigger{task} && later);
  EXPECT_EQ(end.steps, 7u);
  EXPECT_TRUE(end.by<OperatorTrigger>());
  EXPECT_EQ(task.triggers, 0);
}

TEST(Condition, OperatorTriggerIsClearedWhenItIsUsedAgain) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Advance generator(*arm, 0);
  generator.until(OperatorTrigger{task} || ElapsedSteps{3});
  generator.until(When{"trigger", [&] {
                         task.triggers = 1;  // for the next step
                         return false;
                       }});
  EXPECT_EQ(Move({*arm}, {}, generator).steps, 1u);
  EXPECT_EQ(Move({*arm}, {}, generator).steps, 1u);
}

}  // namespace
}  // namespace mrroc::condition_test
