// `mrroc run` with two robots whose drives are on one bus: a hub, or the interface that MRROC_TEST_BUS names.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "replace.hpp"
#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::can_shared_bus_test {
namespace {

namespace fs = std::filesystem;
const fs::path kSource = MRROC_SOURCE_DIR;

/// The IRb-6's table of drives for a second robot on a bus.
fs::path second_table(const ScratchFolder& folder) {
  std::string text = text_of(kSource / "robots/irb6/irb6_drives.toml");
  for (int node = 1; node <= 6; ++node)
    replace(text, "node = " + std::to_string(node) + "\n", "node = " + std::to_string(node + 10) + "\n");
  replace(text, "mode = ", "master = 126\nsync = 0xfe\nmode = ");
  return folder.write("second_drives.toml", text);
}

/// Two arms that move together, on these buses, with the I/O nodes 40 and 41.
fs::path two_arms(const ScratchFolder& folder, const std::string& left, const std::string& right) {
  std::string text = "[deployment]\nname = \"two_arms\"\n[mp]\nprogram = \"" MRROC_BINARY_DIR
                     "/tests/coordinated_mp\"\n[sim]\nscene = \"" +
                     folder.write("empty.xml", "<mujoco><compiler angle='radian'/><worldbody/></mujoco>").string() +
                     "\"\n[[answers]]\nquestion = \"Which?\"\nanswer = \"mirror\"\n";
  const auto add = [&](const std::string& robot, const std::string& place, const std::string& bus,
                       const std::string& node, const std::string& drives) {
    const fs::path io =
        folder.write(robot + "_io.toml",
                     "[[nodes]]\nnode = " + node + "\neds = \"cia401.eds\"\ndigital_inputs = 8\ndigital_outputs = 8\n");
    text += "[robots." + robot + "]\ntype = \"irb6\"\nhardware = \"socketcan\"\nposition = [0.0, " + place +
            ", 0.7]\nprogram = \"" MRROC_BINARY_DIR "/tests/coordinated_ecp\"\n[robots." + robot +
            ".can]\nsimulated = true\ninterface = \"" + bus + "\"\nio = \"" + io.string() + "\"\n" + drives;
  };
  add("left", "1.0", left, "40", "");
  add("right", "-1.0", right, "41", "drives = \"" + second_table(folder).string() + "\"\n");
  return folder.write("two_arms_" + fs::path(left + right).filename().string() + ".toml", text);
}

std::string hash_of_run(const fs::path& deployment, const fs::path& trace) {
  const std::string output =
      run_mrroc({"run", deployment.string(), "--record", trace.string()}, 0, MrrocRun::kLongPatience);
  EXPECT_NE(output.find("with the MP; difference 0.0000"), std::string::npos) << output;
  return trace_hash(trace);
}

TEST(CanSharedBus, TwoRobotsOnOneBusRunAsOnTwo) {
  const ScratchFolder folder;
  const char* const kernel = std::getenv("MRROC_TEST_BUS");
  const std::string hub = "unix:" + folder.path().string() + "/";
  const std::string shared = kernel != nullptr ? kernel : hub + "bus";
  const std::string one = hash_of_run(two_arms(folder, shared, shared), folder.path() / "one.mcap");
  const std::string two = hash_of_run(two_arms(folder, hub + "first", hub + "second"), folder.path() / "two.mcap");
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace mrroc::test::can_shared_bus_test
