#include "mrroc/testing/motion.hpp"

#include <gtest/gtest.h>

#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::task_test {
namespace {

std::map<std::string, Motion> read(const std::string& text) {
  const ScratchFolder folder;
  return read_motion(folder.write("motion", text));
}

constexpr const char* kTwoRobots =
    "# limits arm -1 -2 1 2 0.5 0.6\n"
    "# limits belt -100 100 1\n"
    "0 belt 1\n"
    "1 arm 0 0.1 0.2 0.3 0.4\n"
    "1 belt 0 5 0.5\n"
    "2 arm 0 0.1 0.2 0.3 0.4\n"
    "3 arm 1 0.1 0.2 0 0\n"
    "4 arm 1 0.1 0.2 0 0\n"
    "5 arm 1 0.1 0.";

TEST(Motion, IsReadByRobotAndAnUnfinishedLineIsIgnored) {
  const auto motions = read(kTwoRobots);
  ASSERT_EQ(motions.size(), 2U);
  const Motion& arm = motions.at("arm");
  EXPECT_EQ(arm.ticks, (std::vector<Tick>{1, 2, 3, 4}));
  EXPECT_EQ(arm.positions[0], Eigen::Vector2d(0.1, 0.2));
  EXPECT_EQ(arm.velocities[1], Eigen::Vector2d(0.3, 0.4));
  EXPECT_EQ(arm.velocity_max, Eigen::Vector2d(0.5, 0.6));
  EXPECT_EQ(motions.at("belt").ticks.size(), 1U);
}

TEST(Motion, StandstillBeginsAtTheEndOfTheLastMotion) {
  const auto motions = read(kTwoRobots);
  EXPECT_EQ(motions.at("arm").standstill(), 3U);
  EXPECT_EQ(motions.at("belt").standstill(), kNever);
}

TEST(Motion, RestBeginsWhenTheRobotStandsForAWhile) {
  std::string text = "# limits arm -1 1 1\n";
  const auto add = [&text](Tick from, Tick to, const char* speed) {
    for (Tick tick = from; tick < to; ++tick) text += std::to_string(tick) + " arm 0 0 " + speed + "\n";
  };
  add(0, 20, "0");
  add(20, 30, "0.5");
  add(30, 39, "0.01");  // it turns round
  add(39, 50, "-0.5");
  add(50, 60, "0.02");
  add(60, 70, "0.1");
  add(70, 75, "0");  // to the end
  const Motion arm = read(text).at("arm");
  EXPECT_EQ(arm.at_rest(5), 5U);
  EXPECT_EQ(arm.at_rest(15), 50U);
  EXPECT_EQ(arm.at_rest(31), 50U);
  EXPECT_EQ(arm.at_rest(51), 70U);
  EXPECT_EQ(arm.at_rest(72), 72U);
  EXPECT_EQ(arm.at_rest(75), kNever);
  EXPECT_EQ(arm.at_rest(25, 0.6), 25U);
}

TEST(Motion, ReportsEachPositionBeyondALimit) {
  const auto motions = read(
      "# limits arm -1 1 0.5\n"
      "1 arm 0 1.005 0.54\n"
      "2 arm 0 1.02 0\n"
      "3 arm 0 0 -0.56\n"
      "4 arm 0 nan 0\n");
  const auto places = motions.at("arm").limits_exceeded(0.1);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_DOUBLE_EQ(motions.at("arm").fastest(), 1.12);
  EXPECT_EQ(places[0], "tick 2, joint 1: position 1.020000");
  EXPECT_EQ(places[1], "tick 3, joint 1: velocity -0.560000, limit 0.500000");
  EXPECT_NE(places[2].find("tick 4, joint 1: position"), std::string::npos);
}

TEST(Motion, ToleratesAnOvershootAndMoreWithADisobedientMotor) {
  const Motion arm = read(
                         "# limits arm -1 1 0.5\n"
                         "1 arm 0 0 0.524\n"
                         "2 arm 0 0 0.526\n"
                         "3 arm 0 0 0.749\n"
                         "4 arm 0 0 0.751\n")
                         .at("arm");
  EXPECT_EQ(arm.limits_exceeded().size(), 3U);
  EXPECT_EQ(arm.limits_exceeded(kDisobedience).size(), 1U);
}

TEST(Motion, InvalidLineIsNamed) {
  for (const char* line : {"1 arm 0 0.1 0.2 0.3\n", "1 leg 0 0.1 0.2 0.3 0.4\n", "x\n"}) {
    try {
      read(std::string{"# limits arm -1 -2 1 2 0.5 0.6\n"} + line);
      FAIL() << line;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string{error.what()}.find("motion:2: '"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace mrroc::task_test
