// A sensor that fails while a task uses it: each failure gives its own error, at the step and in the process that met
// it.
#include <gtest/gtest.h>

#include <fstream>

#include "system/mrroc_run.hpp"

namespace mrroc::test::sensor_errors_test {
namespace {

struct Failure {
  const char* name;
  std::string gate;  ///< readings of the gate; they contain the arrival of the part
  const char* keys;  ///< of the gate
  int exit_code;
  const char* message;
};

/// Name in GoogleTest's messages.
void PrintTo(const Failure& failure, std::ostream* out) { *out << failure.name; }

std::string noisy_gate() {
  std::string text;
  for (int k = 0; k < 200; ++k) {
    const double range = 1.0 + ((k * 7919) % 13 - 6) * 0.02;
    text.append(std::to_string(10 * k)).append(" ").append(std::to_string(range)).append("\n");
  }
  return text;
}

class SensorErrors : public testing::TestWithParam<Failure> {};

TEST_P(SensorErrors, EndTheTaskWithTheirOwnError) {
  const Failure& failure = GetParam();
  const ScratchFolder folder;
  std::ofstream(folder.path() / "gate.txt") << "# mrroc readings range\n" << failure.gate;
  std::ofstream(folder.path() / "gate.toml")
      << "[deployment]\nname = \"gate\"\n\n"
         "[robots.arm]\ntype = \"irb6\"\nprogram = \"press_ecp\"\n"
         "hardware = \"loopback\"\n\n"
         "[sensors.wrist]\ntype = \"force_torque\"\nrobot = \"arm\"\n"
         "source = \"replay\"\nreplay = \""
      << MRROC_SOURCE_DIR "/tasks/press_replay/wrist.txt"
      << "\"\n\n[sensors.gate]\ntype = \"ultrasonic\"\nmode = \"non-interactive\"\n"
         "rate = 50\nsource = \"replay\"\nreplay = \"gate.txt\"\n"
      << failure.keys;
  const std::string output = run_mrroc({"run", (folder.path() / "gate.toml").string(), "--quiet"}, failure.exit_code);
  EXPECT_NE(output.find(failure.message), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(
    Gate, SensorErrors,
    testing::Values(
        Failure{"dead", "0 1\n500 nan\n", "", 3,
                "the sensor hardware malfunctions: raw value range is nan, expected a finite number [process arm, "
                "device gate, "
                "step 51, tick 500]"},
        Failure{"frozen", "0 1\n300 0.9\n", "frozen_after = 0.4\n", 3,
                "frozen: range has been 1 for 200 ticks [process arm, device gate, step 21, tick 200]"},
        Failure{"noisy", noisy_gate(), "noise_max = [0.01]\n", 3, "noisy: range has a standard deviation of 0."},
        Failure{"too_near", "0 1\n400 0.001\n", "", 1,
                "range 0.001 m, expected at least 0.02 m, the dead zone [process arm, device gate, step 41, tick 400]"},
        Failure{"late", "100 1\n", "", 1, "no hardware reading yet at tick 0 [process arm, device gate]"}),
    [](const testing::TestParamInfo<Failure>& failure) { return std::string(failure.param.name); });

}  // namespace
}  // namespace mrroc::test::sensor_errors_test
