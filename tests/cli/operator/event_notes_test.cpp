#include "cli/operator/event_notes.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/operator/operator_rig.hpp"
#include "config/entries/events.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli {
namespace {

TEST(EventNotes, NotedEventsAreReadAgain) {
  const task_test::ScratchFolder folder;
  const auto path = folder.path() / "noted.toml";
  const config::Deployment deployment = asking_deployment(config::ClockMode::paced);
  const std::vector<config::Event> events{{0, "start", "", 0, 0},
                                          {5, "pause", "", 0, 0},
                                          {5, "estop", "", 0, 0},
                                          {6, "answer", "parts", 3, 1},
                                          {7, "answer", "mp", 0.1 + 0.2, 2},
                                          {1'000'000'000'000, "stop", "", 0, 0}};
  const int fd = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  EventNotes notes(fd, path, deployment);
  for (const config::Event& event : events) notes.note(event);
  close(fd);
  const std::vector<config::Event> read = config::load_events(path, deployment);
  ASSERT_EQ(read.size(), events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(read[i].tick, events[i].tick);
    EXPECT_EQ(read[i].command, events[i].command);
    EXPECT_EQ(read[i].asker, events[i].asker);
    EXPECT_EQ(read[i].value, events[i].value);
    EXPECT_EQ(read[i].question, events[i].question);
  }
}

TEST(EventNotes, FullDiskIsAnError) {
  const config::Deployment deployment = asking_deployment(config::ClockMode::paced);
  const int fd = open("/dev/full", O_WRONLY | O_CLOEXEC);
  EventNotes notes(fd, "/dev/full", deployment);
  EXPECT_THROW(notes.note({5, "pause", "", 0, 0}), std::runtime_error);
  close(fd);
}

}  // namespace
}  // namespace mrroc::cli
