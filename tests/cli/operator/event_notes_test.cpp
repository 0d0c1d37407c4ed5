#include "cli/operator/event_notes.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/operator/operator_rig.hpp"
#include "config/entries/events.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::event_notes_test {
namespace {

TEST(EventNotes, NotedEventsAreReadAgain) {
  const task_test::ScratchFolder folder;
  const auto path = folder.path() / "noted.toml";
  config::Deployment deployment = asking_deployment(config::ClockMode::paced);
  config::RobotEntry arm;
  arm.name = "arm";
  arm.type = "irb6";
  deployment.robots.push_back(arm);
  const std::vector<config::Event> events{
      {.tick = 0, .command = "start"},
      {.tick = 5, .command = "pause"},
      {.tick = 5, .command = "estop"},
      {.tick = 6, .command = "speed", .value = 12.5},
      {.tick = 6, .command = "answer", .asker = "parts", .value = 3, .question = 1},
      {.tick = 7, .command = "answer", .asker = "mp", .value = 0.1 + 0.2, .question = 2},
      {.tick = 8, .command = "jog", .order = {"arm", "column", "axes", "", -0.1}},
      {.tick = 9, .command = "step", .order = {"arm", "rz", "tool", "", 1e-9}},
      {.tick = 9, .command = "go", .order = {"arm", "", "", "home", 0}},
      {.tick = 9, .command = "tool", .order = {"arm", "", "", "", 0, "standard"}},
      {.tick = 9, .command = "hold", .order = {"arm", "", "", "", 0}},
      {.tick = 9, .command = "output", .order = {"arm", "a3", "", "", 2.5}},
      {.tick = 1'000'000'000'000, .command = "stop"}};
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
    EXPECT_EQ(read[i].order.robot, events[i].order.robot);
    EXPECT_EQ(read[i].order.axis, events[i].order.axis);
    EXPECT_EQ(read[i].order.posture, events[i].order.posture);
    EXPECT_EQ(read[i].order.tool, events[i].order.tool);
    EXPECT_EQ(read[i].order.amount, events[i].order.amount);
    if (!events[i].order.frame.empty()) {
      EXPECT_EQ(read[i].order.frame, events[i].order.frame);
    }
  }
}

TEST(EventNotes, FullDiskIsAnError) {
  const config::Deployment deployment = asking_deployment(config::ClockMode::paced);
  const int fd = open("/dev/full", O_WRONLY | O_CLOEXEC);
  EventNotes notes(fd, "/dev/full", deployment);
  EXPECT_THROW(notes.note({.tick = 5, .command = "pause"}), std::runtime_error);
  close(fd);
}

}  // namespace
}  // namespace mrroc::cli::event_notes_test
