// A recording, written and read: what is read is what was written, whatever becomes of the file.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <memory>
#include <string>
#include <variant>

#include "cli/trace/step_of_line.hpp"
#include "cli/trace/trace_steps.hpp"
#include "messages/cdr_reader.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "recording/recording_reader.hpp"
#include "recording/recording_writer.hpp"
#include "text_of.hpp"

namespace mrroc::recording::recording_test {
namespace {

using messages::mrroc_msgs::Step;

constexpr std::uint64_t kPeriod = 2'000'000;  // ns

config::Deployment deployment() {
  config::Deployment made;
  made.name = "example";
  made.clock = config::ClockMode::lockstep;
  made.servo_period = 0.002;
  return made;
}

class Recording : public testing::Test {
 protected:
  /// A recording of the example trace.
  void write() {
    const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const config::Deployment made = deployment();
    RecordingWriter writer(fd, made, "name = \"example\"\n");
    for (const cli::trace::Item& item : example.items)
      if (const auto* line = std::get_if<cli::trace::Line>(&item))
        writer.write_step(line->process, line->made, messages::to_cdr(cli::trace::to_message(*line, kPeriod)));
    EXPECT_EQ(writer.close(), 0);
    close(fd);
  }
  std::vector<RecordedMessage> read() const {
    std::vector<RecordedMessage> found;
    RecordingReader reader(file);
    while (auto message = reader.next()) found.push_back(*message);
    return found;
  }
  void store(const std::string& bytes) const { std::ofstream(file, std::ios::binary) << bytes; }

  const cli::trace::TraceSteps example = cli::trace::example_trace();
  task_test::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "example.mcap";
};

TEST_F(Recording, IsReadAsItWasWritten) {
  write();
  RecordingReader reader(file);
  EXPECT_EQ(reader.metadata().at("clock"), "lockstep");
  EXPECT_EQ(reader.metadata().at("servo_period"), "0.002");
  std::size_t steps = 0;
  auto expected = example.items.begin();
  while (const auto message = reader.next()) {
    if (message->type != Step::kType) continue;
    while (!std::holds_alternative<cli::trace::Line>(*expected)) ++expected;
    EXPECT_EQ(messages::from_cdr<Step>(message->cdr),
              cli::trace::to_message(std::get<cli::trace::Line>(*expected++), kPeriod));
    ++steps;
  }
  EXPECT_TRUE(reader.complete());
  std::size_t lines = 0;
  for (const cli::trace::Item& item : example.items) lines += std::holds_alternative<cli::trace::Line>(item) ? 1 : 0;
  EXPECT_EQ(steps, lines);
  EXPECT_TRUE(is_recording(file));
}

TEST_F(Recording, IsReadUpToWhereItEnds) {
  write();
  const std::string whole = test::text_of(file);
  const std::vector<RecordedMessage> all = read();
  std::size_t most = 0;
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    store(whole.substr(0, size));
    try {
      const std::vector<RecordedMessage> found = read();
      ASSERT_LE(found.size(), all.size());
      for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i].cdr, all[i].cdr);
      most = std::max(most, found.size());
    } catch (const std::runtime_error& error) {
      // before its beginning is complete
      ASSERT_LT(size, 200U) << error.what();
    }
  }
  EXPECT_EQ(most, all.size()) << "without the index";
}

RC_GTEST_FIXTURE_PROP(Recording, DamagedFileIsReadOrRefused, ()) {
  write();
  std::string bytes = test::text_of(file);
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i)
    bytes[*rc::gen::inRange<std::size_t>(8, bytes.size())] = static_cast<char>(*rc::gen::inRange(0, 256));
  store(bytes);
  try {
    (void)read();
  } catch (const std::runtime_error& error) {
    RC_ASSERT(std::string{error.what()}.starts_with(file.string()));
  }
}

TEST_F(Recording, OtherFilesAreRefused) {
  const auto refusal = [&](const std::string& bytes) -> std::string {
    store(bytes);
    try {
      RecordingReader reader(file);
    } catch (const std::runtime_error& error) {
      return std::string{error.what()}.substr(file.string().size());
    }
    return "";
  };
  EXPECT_EQ(refusal("# mrroc trace 2 clock=real\n"),
            ": is not an MCAP file, expected a recording of `mrroc run --record`");
  EXPECT_EQ(refusal(""), ": is not an MCAP file, expected a recording of `mrroc run --record`");
  const std::string magic = "\x89MCAP0\r\n";
  EXPECT_EQ(refusal(magic), ": is not a recording of a run, expected metadata 'mrroc'");
  // a message of 2^40 bytes, which are not there
  EXPECT_EQ(refusal(magic + "\x05" + std::string("\0\0\0\0\0\1\0\0", 8)),
            ": is not a recording of a run, expected metadata 'mrroc'");
  EXPECT_EQ(refusal(magic + "\x05" + std::string("\x16\0\0\0\0\0\0\0", 8) + std::string(22, '\7')),
            ": byte 8: a message of channel 1799, expected a channel before it");
  EXPECT_THROW(RecordingReader(folder.path() / "missing"), std::runtime_error);
  EXPECT_FALSE(is_recording(folder.path() / "missing"));
}

TEST(RecordingWriter, ReportsAFullDiskAndStops) {
  const int fd = open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(fd, 0);
  RecordingWriter writer(fd, deployment(), "");
  for (Tick tick = 0; tick < 2000; ++tick) writer.write("/arm/steps", tick, Step{});
  EXPECT_EQ(writer.close(), ENOSPC);
  close(fd);
}

}  // namespace
}  // namespace mrroc::recording::recording_test
