// Robots and sensors that a task makes while it runs: when the task has no link to them they are refused at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "system/mrroc_run.hpp"

namespace mrroc::test::late_objects_test {
namespace {

constexpr int kDone = 0, kTask = 1;

struct Case {
  const char* level;    ///< the program that makes it
  const char* kind;     ///< tests/system/programs/late_objects.hpp
  const char* refused;  ///< nothing: it works
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.level << ' ' << each.kind; }

class LateObjects : public testing::TestWithParam<Case> {
 protected:
  static std::string deployment(const std::string& clock) {
    const Case& made = GetParam();
    const bool in_mp = std::string{made.level} == "mp", both = std::string{made.kind} == "in_behaviour";
    const std::string program = "program = \"" MRROC_BINARY_DIR "/tests/late_objects_";
    return std::string{"[deployment]\nname = \""} + made.kind + "\"\nclock = \"" + clock +
           "\"\nheartbeat_timeout = 1\n" + (in_mp ? "[mp]\n" + program + "mp\"\n" : "") +
           "[robots.belt]\ntype = \"conveyor\"\nhardware = \"loopback\"\n" +
           (!in_mp || both ? program + "ecp\"\n" : "") +
           "[sensors.clock]\ntype = \"time\"\n"
           "[sensors.published]\ntype = \"time\"\nmode = \"non-interactive\"\nrate = 100\n";
  }

  static void expect(const std::string& clock) {
    const ScratchFolder folder;
    MrrocRun run({"run", folder.write("late.toml", deployment(clock)).string(), "--quiet"});
    const std::string refused = GetParam().refused;
    EXPECT_EQ(run.wait(), refused.empty() ? kDone : kTask) << run.out() << run.err();
    const std::string errors = run.err();
    if (refused.empty()) {
      EXPECT_EQ(errors, "");
      return;
    }
    EXPECT_NE(errors.find(refused + " is made while the task runs"), std::string::npos) << errors;
    EXPECT_NE(errors.find("member"), std::string::npos) << errors;
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
  }
};

TEST_P(LateObjects, WorkOrAreRefusedInLockstep) { expect("lockstep"); }
TEST_P(LateObjects, WorkOrAreRefusedInRealTime) { expect("real"); }

constexpr const char* kClock = "sensor 'clock'";
constexpr const char* kPublished = "sensor 'published'";
constexpr const char* kBelt = "robot 'belt'";

std::string name_of(const testing::TestParamInfo<Case>& each) {
  return std::string{each.param.level} + "_" + each.param.kind;
}

INSTANTIATE_TEST_SUITE_P(Refused, LateObjects,
                         testing::Values(Case{"ecp", "sensor", kClock}, Case{"ecp", "published_sensor", kPublished},
                                         Case{"ecp", "sensor_in_thread", kClock}, Case{"ecp", "sensor_later", kClock},
                                         Case{"ecp", "second_of_another_sensor", kPublished},
                                         Case{"mp", "sensor", kClock}, Case{"mp", "published_sensor", kPublished},
                                         Case{"mp", "robot", kBelt}, Case{"mp", "robot_in_thread", kBelt},
                                         Case{"mp", "in_part", kClock}, Case{"mp", "in_behaviour", kClock}),
                         name_of);

// an ECP has a link to its robot in any case
INSTANTIATE_TEST_SUITE_P(Works, LateObjects,
                         testing::Values(Case{"ecp", "robot", ""}, Case{"ecp", "second_sensor", ""},
                                         Case{"ecp", "second_robot", ""}, Case{"ecp", "second_caught", ""},
                                         Case{"mp", "second_sensor", ""}, Case{"mp", "second_robot", ""},
                                         Case{"mp", "second_caught", ""}),
                         name_of);

}  // namespace
}  // namespace mrroc::test::late_objects_test
