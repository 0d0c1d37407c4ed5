// The last seconds of a run: what they are, and the file that is made of them.
#include "recording/recent_messages.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <vector>

#include "messages/mrroc_msgs/event.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "recording/recording_reader.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::recording::recent_messages_test {
namespace {

std::vector<std::uint64_t> times_of(const RecentMessages& recent) {
  std::vector<std::uint64_t> times;
  for (const RecentMessages::Message& message : recent.messages()) times.push_back(message.time);
  return times;
}

TEST(RecentMessages, AreThoseOfTheSpanBeforeTheNewest) {
  RecentMessages recent(100);
  for (const std::uint64_t time : {0U, 50U, 100U}) recent.add({"/a", "", "", time, {}});
  EXPECT_EQ(times_of(recent), (std::vector<std::uint64_t>{0, 50, 100}));
  recent.add({"/a", "", "", 140, {}});
  EXPECT_EQ(times_of(recent), (std::vector<std::uint64_t>{50, 100, 140}));
  recent.add({"/a", "", "", 1000, {}});
  EXPECT_EQ(times_of(recent), (std::vector<std::uint64_t>{1000}));
}

TEST(RecentMessages, ThatComeOutOfOrderDoNotEndTheSpanEarly) {
  RecentMessages recent(100);
  for (const std::uint64_t time : {200U, 150U, 210U}) recent.add({"/a", "", "", time, {}});
  EXPECT_EQ(times_of(recent), (std::vector<std::uint64_t>{200, 150, 210}));
}

TEST(RecentMessages, AreSavedAsARecordingMoreThanOnce) {
  const task_test::ScratchFolder folder;
  config::Deployment deployment;
  deployment.clock = config::ClockMode::lockstep;
  deployment.servo_period = 0.002;
  RecordingWriter writer(-1, deployment, "name = \"example\"\n", 1.0);
  EXPECT_TRUE(writer.keeps_last());
  EXPECT_TRUE(writer.empty());
  Tick tick = 0;
  for (const Tick until : {Tick{400}, Tick{3000}}) {
    for (; tick < until; ++tick) {
      messages::mrroc_msgs::Event event;
      event.tick = tick;
      writer.write(kEventTopic, tick, event);
    }
    const std::filesystem::path file = folder.path() / (std::to_string(until) + ".mcap");
    const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    EXPECT_EQ(writer.save(fd), 0);
    close(fd);
    RecordingReader reader(file);
    EXPECT_EQ(reader.metadata().at("last"), "1");
    const Tick first = until <= 500 ? 0 : until - 501;
    Tick expected = first;
    while (const auto message = reader.next()) EXPECT_EQ(message->time, 2'000'000 * expected++);
    EXPECT_EQ(expected, until);
    EXPECT_TRUE(reader.complete());
  }
  const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  EXPECT_EQ(writer.save(full), ENOSPC);
  close(full);
  EXPECT_EQ(writer.close(), 0);
}

}  // namespace
}  // namespace mrroc::recording::recent_messages_test
