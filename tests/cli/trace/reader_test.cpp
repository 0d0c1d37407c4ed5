#include "cli/trace/reader.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <utility>

#include "cli/trace/diff.hpp"
#include "cli/trace/hash.hpp"
#include "cli/trace/step_of_line.hpp"
#include "cli/trace/trace_steps.hpp"
#include "messages/mrroc_msgs/process_end.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::cli::trace::reader_test {
namespace {

using recording::RecordingWriter;

const RecordingWriter::Metadata kLockstep{{"clock", "lockstep"}, {"servo_period", "0.002"}};

/// A recording with this metadata and these messages of the topic /arm/steps.
class Written {
 public:
  explicit Written(RecordingWriter::Metadata metadata)
      : fd_(open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600)), writer_(fd_, 0.002, std::move(metadata), "") {}
  ~Written() { close(fd_); }
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;
  RecordingWriter& writer() { return writer_; }
  Found found() {
    EXPECT_EQ(writer_.close(), 0);
    return check(file);
  }

 private:
  const task_test::ScratchFolder folder_;

 public:
  const std::filesystem::path file = folder_ / "checked.mcap";

 private:
  int fd_;
  RecordingWriter writer_;
};

TEST(TraceReader, RefusesAFileThatIsNotARecording) {
  const task_test::ScratchFolder folder;
  for (const char* text : {"", "hello\n", "# mrroc trace 2 clock=lockstep\n"})
    EXPECT_NE(check(folder.write("other", text)).malformed.find("other: is not an MCAP file, expected a recording"),
              std::string::npos)
        << text;
  EXPECT_THROW(Reader("/no/such/recording"), std::runtime_error);
  EXPECT_THROW(Reader("/"), std::runtime_error) << "a folder";
}

TEST(TraceReader, RefusesMetadataThatAreNotThoseOfARun) {
  EXPECT_NE(Written(RecordingWriter::Metadata{{"clock", "sun"}, {"servo_period", "0.002"}})
                .found()
                .malformed.find("metadata clock: 'sun'"),
            std::string::npos);
  EXPECT_NE(Written(RecordingWriter::Metadata{{"servo_period", "0.002"}}).found().malformed.find("metadata clock: ''"),
            std::string::npos);
  for (const char* const period : {"", "0", "-1", "nan", "fast"})
    EXPECT_NE(Written(RecordingWriter::Metadata{{"clock", "real"}, {"servo_period", period}})
                  .found()
                  .malformed.find("metadata servo_period: '"),
              std::string::npos)
        << period;
}

TEST(TraceReader, NamesAMessageThatIsNotOneOfAStep) {
  Written damaged(kLockstep);
  const TraceSteps example = example_trace();
  damaged.writer().write_step("arm", 1, messages::to_cdr(to_message(example.line(0), 2'000'000)));
  damaged.writer().write_step("arm", 2, std::vector<std::byte>(7));
  EXPECT_NE(damaged.found().malformed.find("checked.mcap:2: "), std::string::npos) << damaged.found().malformed;
  Written wrong(kLockstep);
  messages::mrroc_msgs::Step step = to_message(example.line(0), 2'000'000);
  step.ending = 8;
  wrong.writer().write_step("arm", 1, messages::to_cdr(step));
  EXPECT_NE(wrong.found().malformed.find("checked.mcap:1: ending: '8', expected 0 to 7"), std::string::npos);
}

TEST(TraceReader, RefusesARecordingWithoutSteps) {
  Written none(kLockstep);
  EXPECT_NE(none.found().malformed.find("checked.mcap: no steps of a task, expected"), std::string::npos);
  EXPECT_THROW(hash_of(none.file), NoSteps);
  Reader one(none.file), other(none.file);
  EXPECT_THROW(compare(one, other), NoSteps) << "two of them are not called equal";
  Written ended(kLockstep);
  ended.writer().write("arm/end", 1, messages::mrroc_msgs::ProcessEnd{});
  EXPECT_EQ(ended.found().malformed, "") << "a task without a step is one";
  EXPECT_EQ(hash_of(ended.file).text.size(), 16U);
}

TEST(TraceReader, EmptyRecordingKeepsTheRules) {
  TraceSteps empty;
  empty.clock = "real";
  empty.items.emplace_back(ProcessEnd{0, "arm", 0, 0, 0});
  EXPECT_EQ(check(empty).text(), "");
  EXPECT_EQ(check(empty).verdict.lines, 0U);
}

TEST(TraceReader, ReportsAndIgnoresACutStep) {
  TraceSteps trace = example_trace();
  Line& line = trace.line(6);
  line.cut = true;
  line.robots.clear();
  line.sensors.clear();
  line.conditions.clear();
  for (Item& item : trace.items)
    if (auto* end = std::get_if<ProcessEnd>(&item); end != nullptr && end->process == line.process) end->cut = 1;
  const Found found = check(trace);
  EXPECT_TRUE(found.rules.empty()) << found.text();
  EXPECT_NE(found.text().find("1 steps of process " + line.process + " were too long"), std::string::npos);
}

/// Peak memory of this process, kB.
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(TraceReader, MemoryDoesNotGrowWithTheRecording) {
  Written written(kLockstep);
  Line line = example_trace().line(0);
  constexpr std::uint64_t kLines = 100000;
  for (; line.step < kLines; ++line.step) {
    written.writer().write_step(line.process, line.tick, messages::to_cdr(to_message(line, 2'000'000)));
    RobotEntry& robot = line.robots.front();
    robot.macrostep = std::max(robot.desired_tick, robot.tick);
    robot.tick = line.tick = robot.macrostep + 8;
    robot.desired_tick = robot.macrostep + 10;
  }
  ASSERT_EQ(written.writer().close(), 0);
  const long before = peak_memory();
  const Verdict verdict = check_trace(written.file, [](const std::string& violation) { ADD_FAILURE() << violation; });
  EXPECT_EQ(verdict.lines, kLines);
  EXPECT_EQ(verdict.notes.size(), 1U);
  EXPECT_LT(peak_memory() - before, 16 << 10) << "kB more";
}

}  // namespace
}  // namespace mrroc::cli::trace::reader_test
