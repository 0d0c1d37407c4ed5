// Every mutation of a trace is found, and every rule finds one.
#include <gtest/gtest.h>

#include "cli/trace/format_line.hpp"
#include "cli/trace/mutations.hpp"
#include "language/property.hpp"

namespace mrroc::cli::trace::mutation_test {
namespace {

constexpr int kCases = 50;

/// The first line that differs, in both.
std::string difference(const std::string& one, const std::string& other) {
  std::istringstream first(one), second(other);
  std::string a, b;
  while (a == b && first && second) {
    std::getline(first, a);
    std::getline(second, b);
  }
  return a + "\n" + b;
}

TEST(TraceMutation, TheExampleKeepsEveryRule) {
  const Found found = check_text(example_trace().text());
  EXPECT_EQ(found.text(), "");
  EXPECT_EQ(found.verdict.violations, 0U);
  EXPECT_EQ(found.verdict.instructions, 12U);
  EXPECT_EQ(found.verdict.processes, 4U);
}

class EveryMutation : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryMutation, IsFound) {
  const Mutation mutation = all_mutations()[GetParam()];
  SCOPED_TRACE(mutation.name);
  const TraceText original = example_trace();
  fakes::check_property(kCases, [&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    TraceText spoilt = original;
    if (!mutation.apply(spoilt, random)) RC_FAIL(std::string{mutation.name} + ": the example has no suitable line");
    if (check_text(spoilt.text()).rules.empty())
      RC_FAIL(std::string{mutation.name} + " is not found:\n" + difference(original.text(), spoilt.text()));
  });
}

INSTANTIATE_TEST_SUITE_P(All, EveryMutation, testing::Range(std::size_t{0}, all_mutations().size()));

TEST(TraceMutation, EveryRuleFindsSomething) {
  std::set<std::string> found;
  Random random(1);
  for (const Mutation& mutation : all_mutations()) {
    for (int i = 0; i < kCases; ++i) {
      TraceText spoilt = example_trace();
      mutation.apply(spoilt, random);
      const std::set<std::string> rules = check_text(spoilt.text()).rules;
      found.insert(rules.begin(), rules.end());
    }
  }
  for (const Rule& rule : all_rules()) EXPECT_TRUE(found.contains(rule.name)) << rule.name;
}

}  // namespace
}  // namespace mrroc::cli::trace::mutation_test
