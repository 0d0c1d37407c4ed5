#include <gtest/gtest.h>

#include <algorithm>

#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test {
namespace {

const std::filesystem::path kSensors = std::filesystem::path(MRROC_SOURCE_DIR) / "sensors";

/// Every sensor with a demo, by the name of its folder.
std::vector<std::string> sensors_with_a_demo() {
  std::vector<std::string> sensors;
  for (const auto& entry : std::filesystem::directory_iterator(kSensors))
    if (std::filesystem::exists(entry.path() / "demo.toml")) sensors.push_back(entry.path().filename());
  std::sort(sensors.begin(), sensors.end());
  return sensors;
}

class SensorDemo : public testing::TestWithParam<std::string> {};

TEST_P(SensorDemo, RunsEquallyEveryTime) {
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs("sensors/" + GetParam() + "/demo.toml", folder);
  EXPECT_FALSE(steps_where(runs.trace, [](const auto& step) { return !step.sensors.empty(); }).empty())
      << "there is no reading";
}

INSTANTIATE_TEST_SUITE_P(Sensors, SensorDemo, testing::ValuesIn(sensors_with_a_demo()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace mrroc::test
