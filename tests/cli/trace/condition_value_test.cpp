#include "cli/trace/condition_value.hpp"

#include <gtest/gtest.h>

#include "language/property.hpp"
#include "mrroc/condition.hpp"

namespace mrroc::cli::trace::condition_value_test {
namespace {

class Leaf : public Condition {
 public:
  Leaf(std::string name, bool value) : Condition(std::move(name)), value_(value) {}

 protected:
  bool holds() override { return value_; }

 private:
  bool value_;
};

struct Tree {
  std::shared_ptr<Condition> condition;
  bool has_and = false, has_or = false;  ///< of the language
};

/// A random condition of the language with `leaves` leaves.
Tree random_tree(int leaves, int& number) {
  Tree tree;
  if (leaves == 1) {
    const std::vector<std::string> names{"a", "n", "not", "elapsed 3 steps", "wrist above 10 N"};
    const std::string name = names[*rc::gen::inRange<std::size_t>(0, names.size())] + std::to_string(++number);
    tree.condition = std::make_shared<Leaf>(name, *rc::gen::arbitrary<bool>());
  } else {
    const int first = *rc::gen::inRange(1, leaves);
    const Tree a = random_tree(first, number), b = random_tree(leaves - first, number);
    const bool both = *rc::gen::arbitrary<bool>();
    if (both)
      tree.condition = std::make_shared<Both>(a.condition, b.condition);
    else
      tree.condition = std::make_shared<Either>(a.condition, b.condition);
    tree.has_and = both || a.has_and || b.has_and;
    tree.has_or = !both || a.has_or || b.has_or;
  }
  if (*rc::gen::inRange(0, 4) == 0) tree.condition = std::make_shared<Negated>(tree.condition);
  return tree;
}

std::vector<ConditionEntry> parts_of(const Condition& condition) {
  std::vector<const Condition*> leaves;
  condition.append_leaves(leaves);
  std::vector<ConditionEntry> parts;
  for (const Condition* leaf : leaves) parts.push_back({leaf->name(), leaf->value()});
  return parts;
}

TEST(ConditionValue, EqualsThatOfTheLanguageOrIsUnknown) {
  fakes::check_property(2000, [] {
    int number = 0;
    const Tree tree = random_tree(*rc::gen::inRange(1, 8), number);
    const bool value = tree.condition->evaluate();
    const PossibleValues found = value_of_condition(tree.condition->name(), parts_of(*tree.condition));
    RC_ASSERT((value ? found.may_be_true : found.may_be_false));
    // brackets do not matter where only one of `and` and `or` occurs
    if (!tree.has_and || !tree.has_or) RC_ASSERT((value ? found.is_true() : found.is_false()));
  });
}

PossibleValues value_of(const std::string& name, bool a, bool b, bool c) {
  return value_of_condition(name, {{"a", a}, {"b", b}, {"c", c}});
}

TEST(ConditionValue, AmbiguousBracketsAreTriedInEveryWay) {
  const PossibleValues open = value_of("a and b or c", false, true, true);
  EXPECT_TRUE(open.may_be_true);   // (a and b) or c
  EXPECT_TRUE(open.may_be_false);  // a and (b or c)
  EXPECT_TRUE(value_of("a and b or c", true, false, true).is_true());
  EXPECT_TRUE(value_of("a and b or c", false, true, false).is_false());
  EXPECT_TRUE(value_of("not (a and b) or c", true, true, false).is_false());
}

TEST(ConditionValue, ConditionWithItsOwnNameIsUnknown) {
  const PossibleValues open = value_of("seen", true, true, true);
  EXPECT_TRUE(open.may_be_true && open.may_be_false);
  const PossibleValues part = value_of("seen or c", false, false, false);
  EXPECT_TRUE(part.may_be_true && part.may_be_false);
}

}  // namespace
}  // namespace mrroc::cli::trace::condition_value_test
