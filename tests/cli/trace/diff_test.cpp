#include "cli/trace/diff.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "cli/trace/trace_steps.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::trace::diff_test {
namespace {

Comparison compared(const TraceSteps& first, const TraceSteps& second) {
  const task_test::ScratchFolder folder;
  first.write(folder / "one.mcap");
  second.write(folder / "other.mcap");
  Reader one(folder / "one.mcap"), other(folder / "other.mcap");
  return compare(one, other);
}

class Diff : public testing::Test {
 protected:
  /// The first line from `begin` on for which `fits`.
  template <class Fits>
  std::size_t find(std::size_t begin, Fits fits) const {
    std::size_t i = begin;
    while (!original.is_line(i) || !fits(original.line(i))) ++i;
    return i;
  }

  const TraceSteps original = example_trace();
  TraceSteps changed = original;
};

TEST_F(Diff, EqualTracesHaveNone) {
  const Comparison comparison = compared(original, changed);
  EXPECT_FALSE(comparison.difference);
  EXPECT_GT(comparison.steps, 20U);
}

TEST_F(Diff, NamesTheFirstFieldThatDiffers) {
  const std::size_t i = find(3, [](const Line& line) { return !line.robots.empty(); });
  Line& line = changed.line(i);
  const double before = line.robots[0].joints.at(0);
  line.robots[0].joints[0] = 0.125;
  line.robots[0].pose[1] += 1;
  for (std::size_t k = i + 1; k < changed.items.size(); ++k)
    if (changed.is_line(k)) changed.line(k).held += 1;
  const Comparison comparison = compared(original, changed);
  ASSERT_TRUE(comparison.difference);
  EXPECT_EQ(comparison.difference->field, "joints of robot " + line.robots[0].name + "[0]");
  EXPECT_EQ(std::stod(comparison.difference->first), before);
  EXPECT_EQ(comparison.difference->second, "0.125");
  EXPECT_EQ(comparison.difference->place, "process " + line.process + ", instruction " +
                                              std::to_string(line.instruction) + " (" + line.name + "), step " +
                                              std::to_string(line.step) + ", tick " + std::to_string(line.tick));
}

TEST_F(Diff, FindsASmallestDifference) {
  const std::size_t i =
      find(0, [](const Line& line) { return !line.sensors.empty() && !line.sensors[0].values.empty(); });
  double& value = changed.line(i).sensors[0].values[0];
  value = std::nextafter(value, 1e9);
  ASSERT_TRUE(compared(original, changed).difference);
  EXPECT_EQ(compared(original, changed).difference->field,
            "values of sensor " + changed.line(i).sensors[0].name + "[0]");
}

TEST_F(Diff, NamesAStepThatOneTraceLacks) {
  std::size_t last = changed.items.size() - 1;
  while (!changed.is_line(last)) --last;
  const std::string place = ", step " + std::to_string(changed.line(last).step) + ", ";
  changed.items.erase(changed.items.begin() + static_cast<std::ptrdiff_t>(last));
  const auto missing = compared(original, changed).difference;
  ASSERT_TRUE(missing);
  EXPECT_EQ(missing->field, "");
  EXPECT_EQ(missing->first, "a step");
  EXPECT_EQ(missing->second, "missing");
  EXPECT_NE(missing->place.find(place), std::string::npos) << missing->place;
  EXPECT_EQ(compared(changed, original).difference->first, "missing");
}

TEST_F(Diff, OrderOfTheProcessesDoesNotCount) {
  const std::size_t i = find(0, [&](const Line& line) { return line.process != original.line(0).process; });
  if (original.is_line(i - 1) && original.line(i - 1).process != original.line(i).process)
    std::swap(changed.items[i - 1], changed.items[i]);
  EXPECT_FALSE(compared(original, changed).difference);
}

}  // namespace
}  // namespace mrroc::cli::trace::diff_test
