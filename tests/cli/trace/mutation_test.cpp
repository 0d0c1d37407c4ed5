// Every mutation of a trace is found, and every rule finds one.
#include <gtest/gtest.h>

#include "cli/trace/diff.hpp"
#include "cli/trace/mutations.hpp"
#include "language/property.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::trace::mutation_test {
namespace {

constexpr int kCases = 50;

/// The first difference that `mrroc trace diff` would name.
std::string difference(const TraceSteps& original, const TraceSteps& spoilt) {
  const task_test::ScratchFolder folder;
  original.write(folder / "one.mcap");
  spoilt.write(folder / "other.mcap");
  Reader one(folder / "one.mcap"), other(folder / "other.mcap");
  const auto found = compare(one, other).difference;
  return found ? found->place + ": " + found->field : "only the order";
}

TEST(TraceMutation, TheExampleKeepsEveryRule) {
  const Found found = check(example_trace());
  EXPECT_EQ(found.text(), "");
  EXPECT_EQ(found.verdict.violations, 0U);
  EXPECT_EQ(found.verdict.instructions, 12U);
  EXPECT_EQ(found.verdict.processes, 4U);
}

class EveryMutation : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryMutation, IsFound) {
  const Mutation mutation = all_mutations()[GetParam()];
  SCOPED_TRACE(mutation.name);
  const TraceSteps original = example_trace();
  fakes::check_property(kCases, [&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    TraceSteps spoilt = original;
    if (!mutation.apply(spoilt, random)) RC_FAIL(std::string{mutation.name} + ": the example has no suitable step");
    if (check(spoilt).rules.empty())
      RC_FAIL(std::string{mutation.name} + " is not found:\n" + difference(original, spoilt));
  });
}

INSTANTIATE_TEST_SUITE_P(All, EveryMutation, testing::Range(std::size_t{0}, all_mutations().size()));

TEST(TraceMutation, EveryRuleFindsSomething) {
  std::set<std::string> found;
  Random random(1);
  for (const Mutation& mutation : all_mutations()) {
    for (int i = 0; i < kCases; ++i) {
      TraceSteps spoilt = example_trace();
      mutation.apply(spoilt, random);
      const std::set<std::string> rules = check(spoilt).rules;
      found.insert(rules.begin(), rules.end());
    }
  }
  for (const Rule& rule : all_rules()) EXPECT_TRUE(found.contains(rule.name)) << rule.name;
}

}  // namespace
}  // namespace mrroc::cli::trace::mutation_test
