#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

const std::filesystem::path kSensors = std::filesystem::path(MRROC_SOURCE_DIR) / "sensors";

/// Every sensor that has a demo, by the name of its folder.
std::vector<std::string> sensors_with_a_demo() {
  std::vector<std::string> sensors;
  for (const auto& entry : std::filesystem::directory_iterator(kSensors))
    if (std::filesystem::exists(entry.path() / "demo.toml")) sensors.push_back(entry.path().filename());
  std::sort(sensors.begin(), sensors.end());
  return sensors;
}

class SensorDemo : public testing::TestWithParam<std::string> {};

TEST_P(SensorDemo, RunsTheSameWayEveryTime) {
  const ScratchFolder folder;
  std::string first;
  for (int run = 0; run < 3; ++run) {
    const std::filesystem::path trace = folder.path() / ("trace_" + std::to_string(run));
    run_mrroc(
        {"run", "sensors/" + GetParam() + "/demo.toml", "--quiet", "--clock", "lockstep", "--trace", trace.string()},
        0);
    if (run == 0) first = trace_hash(trace);
    ASSERT_EQ(trace_hash(trace), first) << "run " << run;
  }
  std::ifstream stream(folder.path() / "trace_0");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NE(text.find(" sensor="), std::string::npos) << "nothing was read";
}

INSTANTIATE_TEST_SUITE_P(Sensors, SensorDemo, testing::ValuesIn(sensors_with_a_demo()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace mrroc::test
