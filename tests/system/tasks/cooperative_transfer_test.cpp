#include <gtest/gtest.h>

#include <fstream>

#include "cooperative_transfer/report/report.hpp"
#include "cooperative_transfer/report/variant.hpp"
#include "system/equal_runs.hpp"

namespace mrroc::test::cooperative_transfer_test {
namespace {

using transfer::Report;
using transfer::Variant;

constexpr double kDegree = 0.017453292519943295;

std::vector<std::string> run_of(const std::filesystem::path& deployment, const std::filesystem::path& trace) {
  return {"run", deployment.string(), "--quiet", "--clock", "lockstep", "--record", trace.string()};
}

/// `bench/transfer_sweep` has more bars and takes longer.
class CooperativeTransfer : public testing::TestWithParam<Variant> {};

TEST_P(CooperativeTransfer, BarFollowsItsPathWithoutInternalForce) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "run.mcap";
  const std::string out = run_mrroc(run_of(write_variant(GetParam(), folder.path()), trace), 0);
  const Report report = transfer::read_report(trace);
  EXPECT_TRUE(report.complete) << out;
  EXPECT_LT(report.worst_way(), 0.002);
  EXPECT_LT(report.worst_turn(), 0.5 * kDegree);
  EXPECT_LT(report.worst_internal(), 15);
  EXPECT_EQ(report.skew, 0u);
  // both arms carry exactly the weight of the bar
  const auto& half_way = report.steps[report.steps.size() / 2];
  EXPECT_NEAR(half_way.weight, 9.81 * GetParam().mass, 3);
  std::printf("%g kg: off by %.2f mm, %.3f degrees, internal force %.1f N\n", GetParam().mass,
              1000 * report.worst_way(), report.worst_turn() / kDegree, report.worst_internal());
}

INSTANTIATE_TEST_SUITE_P(Bars, CooperativeTransfer,
                         testing::Values(Variant{0.5, Variant::error_of(1)}, Variant{3, Variant::error_of(2)},
                                         Variant{1.5, Variant::error_of(3)}));

TEST(CooperativeTransferTask, ContinuesAfterAPauseDuringTheTransfer) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "run.mcap", deployment = write_variant(Variant{}, folder.path());
  std::ofstream(deployment, std::ios::app) << "\n[[events]]\ntick = 6000\ncommand = \"pause\"\n"
                                              "\n[[events]]\ntick = 6500\ncommand = \"resume\"\n";
  const std::string out = run_mrroc(run_of(deployment, trace), 0);
  const Report report = transfer::read_report(trace);
  EXPECT_TRUE(report.complete) << out;
  EXPECT_LT(report.worst_internal(), 15);
}

TEST(CooperativeTransferTask, ContinuesAfterLateCommandsDuringTheTransfer) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "run.mcap";
  for (const char* what : {"delay mp by 25 at tick 3500 for 10 ticks", "delay mp by 40 at tick 5000 for 10 ticks"}) {
    auto arguments = run_of(write_variant(Variant{}, folder.path()), trace);
    arguments.insert(arguments.end(), {"--inject", what});
    const std::string out = run_mrroc(arguments, 0);
    const Report report = transfer::read_report(trace);
    EXPECT_TRUE(report.complete) << what << "\n" << out;
    EXPECT_LT(report.worst_internal(), 25) << what;
    expect_laws(trace);
  }
}

TEST(CooperativeTransferTask, AllRunsAreEqualBitForBit) {
  const ScratchFolder folder;
  expect_equal_runs("tasks/cooperative_transfer/cooperative_transfer.toml", folder, MrrocRun::kLongPatience);
}

}  // namespace
}  // namespace mrroc::test::cooperative_transfer_test
