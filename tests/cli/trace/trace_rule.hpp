#pragma once

#include <gtest/gtest.h>

#include "cli/trace/trace_steps.hpp"

namespace mrroc::cli::trace {

/// Places in the example: the first line of an instruction.
inline std::size_t begin_of(const TraceSteps& trace, const std::string& process, std::uint64_t instruction) {
  for (std::size_t i = 0; i < trace.items.size(); ++i)
    if (trace.is_line(i) && trace.line(i).process == process && trace.line(i).instruction == instruction) return i;
  throw std::logic_error("no such instruction");
}

/// The example with a change at a suitable place.
class TraceRule : public testing::Test {
 protected:
  Line& line(const std::string& process, std::uint64_t instruction, std::size_t step) {
    return trace.line(begin_of(trace, process, instruction) + step);
  }
  RobotEntry& arm(std::uint64_t instruction, std::size_t step) { return line("arm", instruction, step).robots.front(); }

  /// `rule` is found, and its text contains `text`.
  void expect(const std::string& rule, const std::string& text = "") const {
    const Found found = check(trace);
    EXPECT_TRUE(found.rules.contains(rule)) << found.text();
    EXPECT_NE(found.text().find(text), std::string::npos) << found.text();
  }
  void expect_only(const std::string& rule, const std::string& text = "") const {
    expect(rule, text);
    EXPECT_EQ(check(trace).rules, std::set<std::string>{rule});
  }
  void expect_none() const { EXPECT_EQ(check(trace).text(), ""); }

  void erase(std::size_t i) { trace.items.erase(trace.items.begin() + static_cast<std::ptrdiff_t>(i)); }

  TraceSteps trace = example_trace();
};

}  // namespace mrroc::cli::trace
