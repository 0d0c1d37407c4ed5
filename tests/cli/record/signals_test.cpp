// Signals of a recording: the numbers of its messages by topic, field and index.
#include "cli/record/signals.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <limits>
#include <string>

#include "messages/geometry_msgs/wrench_stamped.hpp"
#include "messages/mrroc_msgs/robot_state.hpp"
#include "messages/mrroc_msgs/step.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::cli::record::signals_test {
namespace {

class Signals : public testing::Test {
 protected:
  Signals() {
    const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    config::Deployment deployment;
    deployment.clock = config::ClockMode::lockstep;
    deployment.servo_period = 0.002;
    recording::RecordingWriter writer(fd, deployment, "");
    for (Tick tick = 0; tick < 100; ++tick) {
      const double number = static_cast<double>(tick);
      messages::geometry_msgs::WrenchStamped wrench;
      wrench.wrench.force = {number, -number, 2 * number};
      if (tick == 50) wrench.wrench.torque.x = std::numeric_limits<double>::quiet_NaN();
      writer.write("/wrist/wrench", tick, wrench);
      messages::mrroc_msgs::Step step;
      step.tick = tick;
      step.is_move = tick % 2 == 0;
      step.robots.resize(2);
      step.robots[1].joints = {number, 10 * number};
      writer.write("/arm/steps", tick, step);
    }
    EXPECT_EQ(writer.close(), 0);
    close(fd);
  }

  std::vector<Signal> read(const std::string& name, const TimeSpan& span = {}) const {
    return read_signals(file, {name}, span).at(0);
  }
  std::string error_of(const std::string& name, const TimeSpan& span = {}) const {
    try {
      read(name, span);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  task_test::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "r.mcap";
};

TEST_F(Signals, AreNumbersByTopicAndField) {
  for (const char* name : {"/wrist/wrench/wrench.force.z", "/wrist/wrench/wrench/force/z"}) {
    const std::vector<Signal> found = read(name);
    ASSERT_EQ(found.size(), 1U) << name;
    EXPECT_EQ(found[0].name, "/wrist/wrench/wrench.force.z");
    ASSERT_EQ(found[0].values.size(), 100U);
    EXPECT_EQ(found[0].values[7], 14);
    EXPECT_EQ(found[0].times[7], 0.014);
  }
}

TEST_F(Signals, OfAFieldAreAllItsNumbers) {
  const std::vector<Signal> force = read("/wrist/wrench/wrench.force");
  ASSERT_EQ(force.size(), 3U);
  EXPECT_EQ(force[1].name, "/wrist/wrench/wrench.force.y");
  EXPECT_EQ(force[1].values[9], -9);
  EXPECT_EQ(read("/wrist/wrench").size(), 6U) << "without its stamp";
}

TEST_F(Signals, OfListsHaveIndicesThatMayBeLeftOut) {
  const std::vector<Signal> all = read("/arm/steps/robots.joints");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].name, "/arm/steps/robots[1].joints[1]");
  const std::vector<Signal> one = read("/arm/steps/robots[1].joints[1]");
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].values[3], 30);
}

TEST_F(Signals, TruthValuesAreNumbersAndMissingNumbersHaveNoValue) {
  const std::vector<Signal> moves = read("/arm/steps/is_move");
  ASSERT_EQ(moves.size(), 1U);
  EXPECT_EQ(moves[0].values[4], 1);
  EXPECT_EQ(moves[0].values[5], 0);
  EXPECT_EQ(read("/wrist/wrench/wrench.torque.x")[0].values.size(), 99U);
}

TEST_F(Signals, KeepToTheirTimeSpan) {
  const std::vector<Signal> found = read("/wrist/wrench/wrench.force.x", {.from = 0.02, .to = 0.03});
  ASSERT_EQ(found[0].values.size(), 6U);
  EXPECT_EQ(found[0].values.front(), 10);
  EXPECT_EQ(found[0].values.back(), 15);
}

TEST_F(Signals, ThatAreUnknownAreRefusedWithTheNearestName) {
  EXPECT_NE(error_of("/wrist/wrench/wrench.force.w").find("/wrist/wrench/wrench.force.x"), std::string::npos);
  EXPECT_NE(error_of("/wrst/wrench/wrench.force.x").find("/wrist/wrench/wrench.force.x"), std::string::npos);
  for (const char* name : {"", "/", "wrench", "/wrist/wrench/", "/wrist/wrench/wrench.forc", "/arm/steps/robots[2]",
                           "/arm/steps/name", "/wrist/wrench/header.stamp.sec"})
    EXPECT_NE(error_of(name).find(file.string() + ": signal '"), std::string::npos) << name;
}

TEST_F(Signals, WithoutAValueInTheTimeSpanAreRefusedWithIt) {
  const std::string error = error_of("/wrist/wrench/wrench.force.x", {.from = 0.5, .to = 7});
  EXPECT_NE(error.find("from 0.5 s to 7 s"), std::string::npos) << error;
}

TEST_F(Signals, AreListedByTheNamesThatReadThem) {
  const std::vector<std::string> names = signal_names(file);
  EXPECT_GT(names.size(), 12U);
  for (const std::string& name : names) EXPECT_FALSE(read(name).empty()) << name;
}

}  // namespace
}  // namespace mrroc::cli::record::signals_test
