#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "system/mrroc_run.hpp"

namespace mrroc::test::wrong_task_test {
namespace {

/// The error in the task (tests/system/programs/faulty.cpp), the exit code, and the reason on stderr.
struct Fault {
  const char* kind;
  int exit_code;
  const char* reason;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.kind; }

class WrongTask : public testing::TestWithParam<Fault> {
 protected:
  /// A gate that detects nothing, beside the arm.
  static std::string deployment(const std::string& clock) {
    return faulty_deployment(GetParam().kind, clock) +
           "[sensors.gate]\ntype = \"ultrasonic\"\nsource = \"replay\"\nreplay = \"" MRROC_SOURCE_DIR
           "/tasks/press_replay/gate.txt\"\n";
  }

  static void expect_reason(const std::string& clock) {
    const ScratchFolder folder;
    MrrocRun run({"run", folder.write("faulty.toml", deployment(clock)).string(), "--quiet"});
    EXPECT_EQ(run.wait(), GetParam().exit_code) << run.out() << run.err();
    const std::string errors = run.err();
    EXPECT_NE(errors.find(GetParam().reason), std::string::npos) << errors;
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), *GetParam().reason == '\0' ? 0 : 1) << errors;
  }
};

TEST_P(WrongTask, EndsWithItsReasonInLockstep) { expect_reason("lockstep"); }
TEST_P(WrongTask, EndsWithItsReasonInRealTime) { expect_reason("real"); }

constexpr int kNone = 0;
constexpr int kTask = 1;
constexpr int kHardware = 3;
constexpr int kSystem = 4;

// the task itself checks that the robot has not moved
INSTANTIATE_TEST_SUITE_P(Refused, WrongTask,
                         testing::Values(Fault{"sensor", kTask, "the deployment has no sensor 'ghost', it has: gate"},
                                         Fault{"sensor_type", kTask,
                                               "sensor 'gate' is of type 'ultrasonic' in the deployment"},
                                         Fault{"robot_type", kTask, "robot 'arm' is of type 'irb6' in the deployment"},
                                         Fault{"macrostep", kTask, "motion_steps N is out of range"},  //
                                         Fault{"target", kTask, "the pose is out of the workspace"},
                                         Fault{"pose", kTask, "the pose is out of the workspace"},                 //
                                         Fault{"nan", kTask, "a value is not finite: joints of axis 3"},           //
                                         Fault{"infinite", kTask, "a value is not finite: joints of axis 3"},      //
                                         Fault{"limit", kTask, "a joint position limit would be passed: axis 3"},  //
                                         Fault{"fast", kTask, "a joint velocity limit would be passed: axis 3"},   //
                                         Fault{"axes", kTask, "joints has 5 values, expected 6"},                  //
                                         Fault{"steps", kTask, "motion_steps N is out of range"},
                                         Fault{"many_steps", kTask, "motion_steps N is out of range"},
                                         Fault{"reply", kTask, "reply_step v is out of range"}),
                         [](const auto& test) { return std::string{test.param.kind}; });

INSTANTIATE_TEST_SUITE_P(Failed, WrongTask,
                         testing::Values(Fault{"exception", kSystem, "the task failed: a task's own exception"},
                                         Fault{"hardware", kHardware,
                                               "hardware error: a drive reports a fault: thrown by the task"},
                                         Fault{"crash", kSystem, "process arm died: signal 6 (Aborted)"}),
                         [](const auto& test) { return std::string{test.param.kind}; });

INSTANTIATE_TEST_SUITE_P(Caught, WrongTask, testing::Values(Fault{"caught", kNone, ""}),
                         [](const auto& test) { return std::string{test.param.kind}; });

}  // namespace
}  // namespace mrroc::test::wrong_task_test
