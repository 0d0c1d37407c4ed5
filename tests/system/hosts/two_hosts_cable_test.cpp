// Behaviour of a run when the cable between its hosts is disturbed or cut.
#include <gtest/gtest.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "mrroc/testing/motion.hpp"
#include "system/hosts/two_hosts.hpp"

namespace mrroc::test::two_hosts_cable_test {
namespace {

using task_test::Motion;
using task_test::read_motion;

/// Waits until the arm is moving fast; returns its motion so far, which the simulator writes meanwhile.
Motion await_motion(MrrocRun& run, const std::filesystem::path& file) {
  constexpr double kFast = 0.1;  // rad/s: five times the threshold of rest
  for (;; pause_for(0.005)) {
    if (run.has_ended()) throw std::runtime_error("it has ended: " + run.out() + run.err());
    if (!std::filesystem::exists(file)) continue;
    const auto motions = read_motion(file);
    const auto arm = motions.find("arm");
    if (arm == motions.end() || arm->second.ticks.empty()) continue;
    if (arm->second.velocities.back().cwiseAbs().maxCoeff() > kFast) return arm->second;
  }
}

/// The arm, which moved at the tick `moving`, has come to rest after it, and at no tick exceeded a limit.
void expect_stop(const std::filesystem::path& file, Tick moving) {
  const Motion motion = read_motion(file).at("arm");
  const Tick stands = motion.standstill();
  ASSERT_NE(stands, kNever) << "it moved to the end, tick " << motion.ticks.back();
  EXPECT_GT(stands, moving);
  EXPECT_EQ(motion.limits_exceeded(0.05), std::vector<std::string>{});
  std::printf("moved at tick %llu, stood from tick %llu to the end at %llu, at most %.2f of its speed limit\n",
              static_cast<unsigned long long>(moving), static_cast<unsigned long long>(stands),
              static_cast<unsigned long long>(motion.ticks.back()), motion.fastest());
}

/// Behaviour that the messages' signatures may change.
class TwoHostsWithOrWithoutKeys : public TwoHosts, public testing::WithParamInterface<bool> {
  bool with_keys() const override { return GetParam(); }
};

INSTANTIATE_TEST_SUITE_P(Security, TwoHostsWithOrWithoutKeys, testing::Bool(),
                         [](const auto& test) { return test.param ? "keys" : "no_keys"; });

TEST_P(TwoHostsWithOrWithoutKeys, ContinueOverABadCable) {
  const auto trace = file("press.mcap");
  const CableFaults faults{.delay = 0.005, .jitter = 0.002, .loss = 0.02, .duplicate = 0.02, .reorder = 0.02};
  // with keys only after the start, which may fail when handshake messages are lost (docs/how-to/two-hosts.md)
  if (!GetParam()) cable_->set(faults);
  const auto deployment = write(hosts("two", "link_timeout = 2\nclock_error = 0.02\n", {}, press()));
  MrrocRun& run = start_until("running", deployment, {"--record", trace.string()});
  cable_->set(faults);
  EXPECT_EQ(run.wait(MrrocRun::kLongPatience), 0) << output();
  const Cable::Counts counts = cable_->counts();
  EXPECT_GT(counts.lost, 20U);
  EXPECT_GT(counts.duplicated, 20U);
  EXPECT_GT(counts.reordered, 20U);
  expect_laws(trace);
}

/// Every step of the arm comes from the MP on the other side of the cable.
TEST_P(TwoHostsWithOrWithoutKeys, StopBothWhenTheCableIsCut) {
  MrrocRun& run =
      start(write(hosts("two", "link_timeout = 0.2\n", {}, press())), {"--motion", file("motion").string()});
  const Tick moving = await_motion(run, file("motion")).ticks.back();
  const std::vector<pid_t> pids = run.descendants();
  EXPECT_GE(pids.size(), 7U);
  cable_->set({.cut = true});
  expect_end(kSystem, "lost: nothing received for 0.2", pids);
  expect_stop(file("motion"), moving);
}

/// No process on this arm's host needs the cable: only the silence of the link stops the arm.
TEST_F(TwoHostsWithKeys, StopAnArmThatItsOwnHostMoves) {
  MrrocRun& run = start(write(hosts("to_and_fro", "link_timeout = 0.2\n", {}, to_and_fro())),
                        {"--motion", file("motion").string()});
  const Tick moving = await_motion(run, file("motion")).ticks.back();
  const std::vector<pid_t> pids = run.descendants();
  cable_->set({.cut = true});
  expect_end(kSystem, "lost: nothing received for 0.2", pids);
  expect_stop(file("motion"), moving);
}

TEST_F(TwoHostsWithKeys, DropCorruptedFrames) {
  MrrocRun& run = start_until("running", write(hosts("two", kPatientLink, {}, press())));
  cable_->set({.corrupt = 0.05});
  EXPECT_EQ(run.wait(), 0) << output();
  EXPECT_GT(cable_->counts().corrupted, 50U);
}

TEST_F(TwoHostsWithKeys, TolerateAShortCut) {
  MrrocRun& run = start_until("JointLine", write(hosts("two", kPatientLink, {}, press())));
  cable_->set({.cut = true});
  pause_for(0.15);
  cable_->set({});
  EXPECT_EQ(run.wait(), 0) << output();
  EXPECT_GT(cable_->counts().lost, 10U);
}

/// One of two arms is at rest on host a; a stop of the other one stops it, too.
TEST_F(TwoHosts, StopARobotOnEitherSide) {
  const std::string second = "[robots.second]\ntype = \"irb6\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR
                             "/tests/faulty_ecp\"\n";
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold() + second)));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  pause_for(0.3);
  const std::vector<pid_t> pids = run.descendants();
  ASSERT_EQ(parent_of(run.descendant("second_edp")), run.pid());
  cable_->set({.cut = true});
  expect_end(kSystem, "lost: nothing received for 2", pids);
  EXPECT_EQ(run.out().find("killing it"), std::string::npos) << output();
}

}  // namespace
}  // namespace mrroc::test::two_hosts_cable_test
