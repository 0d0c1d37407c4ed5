#include "cli/trace/reader.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>

#include "cli/trace/format_line.hpp"
#include "cli/trace/trace_text.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::trace::reader_test {
namespace {

TEST(TraceReader, RefusesAFileThatIsNotATrace) {
  for (const char* text : {"", "hello\n", "# mrroc trace 1\n", "# mrroc trace 2 clock=sun\n"})
    EXPECT_NE(
        check_text(text).malformed.find(".trace:1: is not a trace, expected the line \"# mrroc trace 2 clock=..."),
        std::string::npos)
        << text;
  EXPECT_THROW(Reader("/no/such/trace"), std::runtime_error);
  EXPECT_THROW(Reader("/"), std::runtime_error) << "a folder";
}

TEST(TraceReader, NamesAnInvalidLine) {
  const std::string text = example_trace().text();
  const std::size_t third = text.find('\n', text.find('\n') + 1) + 1;
  const std::string broken = text.substr(0, third) + "tick=abc\n" + text.substr(third);
  EXPECT_NE(check_text(broken).malformed.find(".trace:3: tick: 'abc', expected a whole number"), std::string::npos)
      << check_text(broken).malformed;
  EXPECT_NE(check_text(text + "# anything else\n").malformed.find("remark: "), std::string::npos);
  EXPECT_NE(check_text(text + "\n").malformed.find("tick: ''"), std::string::npos);
  EXPECT_NE(check_text(text + std::string(20000, 'x') + "\n").malformed.find("at most 16384 characters"),
            std::string::npos);
}

TEST(TraceReader, AcceptsAdditionsOfEditors) {
  const std::string text = example_trace().text();
  const Found plain = check_text(text);
  ASSERT_EQ(plain.malformed, "");
  for (const char* const end : {"\r\n", " \n", "\t\r\n", "\n"}) {
    std::string changed = "\xEF\xBB\xBF";
    for (const char c : text) changed += c == '\n' ? end : std::string(1, c);
    const Found found = check_text(changed);
    EXPECT_EQ(found.malformed, "");
    EXPECT_EQ(found.text(), plain.text());
    EXPECT_EQ(found.verdict.lines, plain.verdict.lines);
  }
  EXPECT_NE(check_text("\xFF\xFE#").malformed.find(":1: the file is in UTF-16"), std::string::npos);
  const std::string zero = text + std::string("tick\0\n", 6);
  EXPECT_NE(check_text(zero).malformed.find("a byte \\x00 at column 5"), std::string::npos);
}

TEST(TraceReader, EmptyTraceKeepsTheRules) {
  const Found found = check_text("# mrroc trace 2 clock=real\n# process=arm lines=0 dropped=0 cut=0\n");
  EXPECT_EQ(found.text(), "");
  EXPECT_EQ(found.verdict.lines, 0U);
}

TEST(TraceReader, ReportsAndIgnoresACutLine) {
  TraceText trace = example_trace();
  const std::string before = format_line(trace.line(6));
  std::string cut = before;
  cut.resize(16384, '0');
  std::string text = trace.text();
  text.replace(text.find(before), before.size(), cut);
  EXPECT_TRUE(check_text(text).rules.empty()) << check_text(text).text();
}

/// Peak memory of this process, kB.
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(TraceReader, MemoryDoesNotGrowWithTheTrace) {
  const task_test::ScratchFolder folder;
  const std::filesystem::path file = folder / "long.trace";
  Line line = example_trace().line(0);
  constexpr std::uint64_t kLines = 100000;
  {
    std::ofstream out(file);
    out << "# mrroc trace 2 clock=lockstep\n";
    for (; line.step < kLines; ++line.step) {
      out << format_line(line) << "\n";
      RobotEntry& robot = line.robots.front();
      robot.macrostep = std::max(robot.desired_tick, robot.tick);
      robot.tick = line.tick = robot.macrostep + 8;
      robot.desired_tick = robot.macrostep + 10;
    }
  }
  const long before = peak_memory();
  const Verdict verdict = check_trace(file, [](const std::string& violation) { ADD_FAILURE() << violation; });
  EXPECT_EQ(verdict.lines, kLines);
  EXPECT_EQ(verdict.notes.size(), 1U);
  EXPECT_GT(std::filesystem::file_size(file), 30U << 20U);
  EXPECT_LT(peak_memory() - before, 8 << 10) << "kB more";
}

}  // namespace
}  // namespace mrroc::cli::trace::reader_test
