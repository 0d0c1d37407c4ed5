#include "cli/trace/trace_steps.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

#include "cli/trace/step_of_line.hpp"
#include "messages/mrroc_msgs/process_end.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::cli::trace {

namespace {

constexpr std::uint64_t kPeriod = 2'000'000;  // ns

}  // namespace

void TraceSteps::write(const std::filesystem::path& file) const {
  recording::RecordingWriter::Metadata metadata{{"clock", clock}, {"servo_period", "0.002"}};
  if (black_box) metadata.emplace(recording::kBlackBox, "yes");
  const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  recording::RecordingWriter writer(fd, 0.002, metadata, "");
  Tick newest = 0;
  for (const Item& item : items) {
    if (const Line* line = std::get_if<Line>(&item)) {
      newest = std::max(newest, line->made);
      writer.write_step(line->process, line->made, messages::to_cdr(to_message(*line, kPeriod)));
      continue;
    }
    const ProcessEnd& end = std::get<ProcessEnd>(item);
    messages::mrroc_msgs::ProcessEnd message;
    message.process = end.process;
    message.steps = end.lines;
    message.dropped = end.dropped;
    message.cut = end.cut;
    writer.write(recording::kEndTopic, newest, message);
  }
  EXPECT_EQ(writer.close(), 0);
  close(fd);
}

TraceSteps read_trace(const std::filesystem::path& file) {
  TraceSteps trace;
  Reader reader(file);
  trace.clock = reader.simulated() ? "lockstep" : "real";
  trace.black_box = reader.black_box();
  for (;;) {
    const auto item = reader.next();
    if (const Line* line = std::get_if<Line>(&item))
      trace.items.emplace_back(*line);
    else if (const ProcessEnd* end = std::get_if<ProcessEnd>(&item))
      trace.items.emplace_back(*end);
    else
      return trace;
  }
}

std::size_t line_count(const TraceSteps& whole, const std::string& process) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < whole.items.size(); ++i)
    count += whole.is_line(i) && whole.line(i).process == process ? 1 : 0;
  return count;
}

TraceSteps black_box_of(const TraceSteps& whole, const std::string& process, std::size_t begin, std::size_t end) {
  TraceSteps box;
  box.clock = whole.clock;
  box.black_box = true;
  std::size_t number = 0;
  for (std::size_t i = 0; i < whole.items.size(); ++i) {
    if (!whole.is_line(i) || whole.line(i).process != process) continue;
    if (number >= begin && number < end) box.items.push_back(whole.items[i]);
    ++number;
  }
  ProcessEnd last;
  last.process = process;
  last.lines = box.items.size();
  box.items.emplace_back(last);
  return box;
}

std::string Found::text() const {
  std::string all = malformed;
  for (const std::string& violation : violations) all += violation + "\n";
  for (const std::string& note : verdict.notes) all += note + "\n";
  return all;
}

Found check(const TraceSteps& trace) {
  const task_test::ScratchFolder folder;
  trace.write(folder / "checked.mcap");
  return check(folder / "checked.mcap");
}

Found check(const std::filesystem::path& file) {
  Found found;
  try {
    found.verdict = check_trace(file, [&found](const std::string& violation) {
      found.violations.push_back(violation);
      const std::size_t begin = violation.find(": ") + 2;
      found.rules.insert(violation.substr(begin, violation.find(": ", begin) - begin));
    });
  } catch (const std::runtime_error& error) {
    found.malformed = error.what();
  }
  return found;
}

}  // namespace mrroc::cli::trace
