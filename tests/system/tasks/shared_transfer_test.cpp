// The transfer by two arms as the paper has it: the MP moves the bar, each ECP gives way to what its own wrist feels.
#include <gtest/gtest.h>

#include <cstdlib>

#include "cooperative_transfer/report/report.hpp"
#include "cooperative_transfer/report/variant.hpp"
#include "replace.hpp"
#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::shared_transfer_test {
namespace {

using transfer::Report;
using transfer::Variant;

constexpr double kDegree = 0.017453292519943295;

/// The two arms, and the programs of this test for them.
struct Carriers {
  const transfer::Arms& arms;
  std::string type, program;
  std::string forward, height;  ///< m, of their bases
};
const Carriers kSix{transfer::kSixAxes, "irb6", "shared_transfer", "0.0", "0.7"};
const Carriers kFive{transfer::kFiveAxes, "irb6_five_axis", "five_axis_transfer", "0.14", "0.86"};

/// The task's deployment with the programs of this test. `comply`: the answer to the MP's question.
std::filesystem::path deployment(const Carriers& by, const Variant& variant, const std::string& comply,
                                 const ScratchFolder& folder) {
  std::string text = text_of(write_variant(variant, folder.path()));
  const std::string program = MRROC_BINARY_DIR "/tests/" + by.program;
  replace(text, "cooperative_transfer_mp", program + "_mp");
  for (const std::string arm : {"left", "right"}) {
    const std::string table = "[robots." + arm + "]\n";
    replace(text, table + "type = \"irb6\"",
            table + "type = \"" + by.type + "\"\nprogram = \"" + program + "_ecp\"\nforce_sensor = \"" + arm +
                "_wrist\"\ntorque_limit = [10.0, 10.0, 10.0]");
    const std::string side = arm == "left" ? "0.45, " : "-0.45, ";
    replace(text, "[0.0, " + side + "0.7]", "[" + by.forward + ", " + side + by.height + "]");
  }
  const auto answer = [](const std::string& question, const std::string& given) {
    return "\n[[answers]]\nquestion = \"" + question + "\"\nanswer = \"" + given + "\"\n";
  };
  return folder.write("shared_transfer.toml",
                      text + answer("Do the arms comply?", comply) + answer("Mass?", std::to_string(variant.mass)));
}

unsigned seeds() {
  const char* const given = std::getenv("MRROC_TEST_SEEDS");
  return given != nullptr ? static_cast<unsigned>(std::atoi(given)) : 2;
}

void expect_relieved(const Carriers& by, unsigned seed) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "run.mcap";
  const auto file = deployment(by, Variant{1.5, Variant::error_of(seed)}, "yes", folder);
  const std::string out = run_mrroc({"run", file.string(), "--quiet", "--record", trace.string()}, 0);
  const Report report = transfer::read_report(trace, by.arms);
  EXPECT_TRUE(report.complete) << "seed " << seed << "\n" << out;
  EXPECT_LT(report.worst_internal(), 15) << "seed " << seed;
  EXPECT_LT(report.worst_turn(), 0.5 * kDegree) << "seed " << seed;
  EXPECT_EQ(report.skew, 0U);
  std::printf("%s, seed %u: off by %.2f mm, %.3f degrees, internal force %.1f N, %.1f RMS\n", by.type.c_str(), seed,
              1000 * report.worst_way(), report.worst_turn() / kDegree, report.worst_internal(), report.rms_internal());
}

TEST(SharedTransfer, ArmsRelieveTheBarByTheirOwnSensors) {
  for (unsigned seed = 1; seed <= seeds(); ++seed) expect_relieved(kSix, seed);
}

/// The paper's arms.
TEST(SharedTransfer, ArmsOfFiveAxesRelieveTheBarByTheirOwnSensors) {
  for (unsigned seed = 1; seed <= seeds(); ++seed) expect_relieved(kFive, seed);
}

/// The errors of a real lab in everything: bases, links, transmissions, friction, sensors
/// (docs/reference/simulated-errors.md).
TEST(SharedTransfer, ArmsRelieveTheBarInAWorldWithModestErrors) {
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    const ScratchFolder folder;
    const auto trace = folder.path() / "run.mcap";
    const auto file = deployment(kSix, Variant{1.5, Pose::Identity()}, "yes", folder);
    const std::string out = run_mrroc({"run", file.string(), "--quiet", "--record", trace.string(), "--errors",
                                       "modest", "--seed", std::to_string(seed)},
                                      0);
    const Report report = transfer::read_report(trace);
    EXPECT_TRUE(report.complete) << "seed " << seed << "\n" << out;
    EXPECT_LT(report.worst_internal(), 15) << "seed " << seed;
    EXPECT_LT(report.worst_turn(), 0.5 * kDegree) << "seed " << seed;
    std::printf("modest errors, seed %u: off by %.2f mm, %.3f degrees, internal force %.1f N, %.1f RMS\n", seed,
                1000 * report.worst_way(), report.worst_turn() / kDegree, report.worst_internal(),
                report.rms_internal());
  }
}

TEST(SharedTransfer, WithoutComplianceTheArmsWorkAgainstEachOther) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "run.mcap";
  const auto file = deployment(kSix, Variant{1.5, Variant::error_of(1)}, "no", folder);
  run_mrroc({"run", file.string(), "--quiet", "--record", trace.string()}, 1);  // a force limit ends it
  const Report report = transfer::read_report(trace);
  EXPECT_FALSE(report.complete);
  EXPECT_GT(report.worst_internal(), 15);
}

}  // namespace
}  // namespace mrroc::test::shared_transfer_test
