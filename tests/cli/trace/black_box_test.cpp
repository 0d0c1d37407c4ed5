// A black box is the end of a process's trace and may begin anywhere: the rules hold there, and still find errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "cli/trace/trace_steps.hpp"

namespace mrroc::cli::trace::black_box_test {
namespace {

TEST(BlackBoxOfATrace, EveryPartOfATraceKeepsTheRules) {
  for (const char* clock : {"lockstep", "real"}) {
    TraceSteps whole = example_trace();
    whole.clock = clock;
    for (const std::string process : {"arm", "mp"}) {
      const std::size_t lines = line_count(whole, process);
      ASSERT_GT(lines, 8U);
      for (std::size_t begin = 0; begin < lines; ++begin) {
        for (const std::size_t end : {begin + 1, begin + 2, begin + 7, lines}) {
          const TraceSteps box = black_box_of(whole, process, begin, std::min(end, lines));
          ASSERT_EQ(check(box).text(), "") << process << " from " << begin << " to " << end;
        }
      }
    }
  }
}

/// The end of each process's part, of its own length: between them, lines of the other one may be missing.
TEST(BlackBoxOfATrace, TheLastLinesOfSeveralProcessesKeepTheRules) {
  const TraceSteps whole = example_trace();
  const std::size_t arm = line_count(whole, "arm"), mp = line_count(whole, "mp"), slide = line_count(whole, "slide");
  for (std::size_t of_arm = 0; of_arm <= arm; ++of_arm) {
    for (std::size_t of_mp = 0; of_mp <= mp; ++of_mp) {
      std::map<std::string, std::size_t> kept{
          {"arm", of_arm}, {"mp", of_mp}, {"slide", of_arm % (slide + 1)}, {"station", of_mp % (slide + 1)}};
      std::map<std::string, std::size_t> skipped{{"arm", arm - of_arm},
                                                 {"mp", mp - of_mp},
                                                 {"slide", slide - kept["slide"]},
                                                 {"station", slide - kept["station"]}};
      TraceSteps box;
      box.black_box = true;
      for (const Item& item : whole.items) {
        if (std::holds_alternative<Line>(item)) {
          std::size_t& left_out = skipped[std::get<Line>(item).process];
          if (left_out > 0)
            --left_out;
          else
            box.items.push_back(item);
          continue;
        }
        ProcessEnd end = std::get<ProcessEnd>(item);
        end.lines = kept[end.process];
        box.items.emplace_back(end);
      }
      ASSERT_EQ(check(box).text(), "") << of_arm << " of arm, " << of_mp << " of mp";
    }
  }
}

TEST(BlackBoxOfATrace, WithoutTheMarkItsBeginningIsAViolation) {
  TraceSteps box = black_box_of(example_trace(), "arm", 1, 12);
  box.black_box = false;
  EXPECT_TRUE(check(box).rules.contains("step-count"));
}

TEST(BlackBoxOfATrace, FindsErrors) {
  const TraceSteps whole = example_trace();
  const std::size_t lines = line_count(whole, "arm");
  std::size_t steps = 0, missing = 0, targets = 0;
  for (std::size_t begin = 0; begin + 4 < lines; ++begin) {
    TraceSteps box = black_box_of(whole, "arm", begin, begin + 4);
    Line& third = box.line(2);
    if (box.line(1).instruction != third.instruction) continue;
    // a line twice
    TraceSteps twice = box;
    twice.items.insert(twice.items.begin() + 2, twice.items[2]);
    std::get<ProcessEnd>(twice.items.back()).lines = 5;
    if (!third.ends()) {
      EXPECT_TRUE(check(twice).rules.contains("step-count"));
      ++steps;
    }
    TraceSteps gone = box;
    gone.items.erase(gone.items.begin() + 2);
    EXPECT_TRUE(check(gone).rules.contains("every-step"));
    ++missing;
    if (third.robots.empty() || third.held != 0 || third.broken_off() || third.robots[0].error != ErrorClass::none ||
        box.line(1).robots[0].command->kind != CommandKind::joint || box.line(1).robots[0].command->relative ||
        box.line(0).instruction != third.instruction)
      continue;
    third.robots[0].desired.at(0) += 0.01;
    EXPECT_TRUE(check(box).rules.contains("joint-target"));
    ++targets;
  }
  EXPECT_GT(steps, 5U);
  EXPECT_GT(missing, 5U);
  EXPECT_GT(targets, 2U);
}

TEST(BlackBoxOfATrace, AnUnknownClockIsRefused) {
  TraceSteps box = black_box_of(example_trace(), "arm", 0, 4);
  box.clock = "sun";
  EXPECT_NE(check(box).malformed.find("metadata clock: 'sun', expected real, paced or lockstep"), std::string::npos);
}

}  // namespace
}  // namespace mrroc::cli::trace::black_box_test
