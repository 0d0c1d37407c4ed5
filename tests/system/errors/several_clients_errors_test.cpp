// A sensor that fails, or dies, while the MP and two ECPs use it.
#include <gtest/gtest.h>
#include <signal.h>

#include <tuple>

#include "system/client_looks.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::several_clients_errors_test {
namespace {

/// A sensor without valid readings from tick 150 on.
struct Failure {
  const char* name;
  const char* device;
  std::string type, readings;
  int exit_code;
  const char* message;
};

/// Name in GoogleTest's messages.
void PrintTo(const Failure& failure, std::ostream* out) { *out << failure.name; }

class FailingSensor : public testing::TestWithParam<Failure> {};

TEST_P(FailingSensor, IsReportedToEachClientAtItsNextReading) {
  const Failure& failure = GetParam();
  const bool shared = failure.device == std::string("shared");
  const ScratchFolder folder;
  folder.write("readings.txt", failure.readings);
  const std::string played = "type = \"" + failure.type + "\"\nsource = \"replay\"\nreplay = \"readings.txt\"\n";
  const auto file =
      folder.write("clients.toml", clients_deployment("clients", shared ? played : kTime, shared ? kTime : played));
  const auto trace = folder.path() / "trace.mcap";
  const std::string output =
      run_mrroc({"run", file.string(), "--quiet", "--record", trace.string()}, failure.exit_code);
  const auto looks = looks_of(trace);
  ASSERT_EQ(looks.size(), 3u) << output;
  for (const auto& [client, steps] : looks) {
    SCOPED_TRACE(client + "\n" + output);
    const auto met = output.find(client + " | met ");
    ASSERT_NE(met, std::string::npos);
    const std::string line = output.substr(met, output.find('\n', met) - met);
    EXPECT_NE(line.find(failure.message), std::string::npos);
    EXPECT_NE(line.find("[process " + client + ", device " + failure.device + ", step "), std::string::npos);
    const double step = number_after(line, ", step "), tick = number_after(line, ", tick ");
    EXPECT_EQ(step, steps.back().step + 1);
    EXPECT_EQ(static_cast<int>(step) % (shared ? kPeriods.at(client) : 1), 0);
    const double own = 2 * steps.back().own - steps[steps.size() - 2].own;  // all steps have the same length
    EXPECT_EQ(tick, shared ? own : 160);
    EXPECT_GE(tick, 150);
    EXPECT_LT(shared ? steps.back().shared : steps.back().free, 150);
    if (client != "left") continue;  // the first that fails: its error is what ends the MP
    EXPECT_NE(output.find("mp | " + line.substr(line.find("met ") + 4)), std::string::npos);
  }
  const auto named = output.find("mrroc: clients: ");
  ASSERT_NE(named, std::string::npos) << output;
  EXPECT_NE(output.find(failure.message, named), std::string::npos) << output;
  EXPECT_EQ(output.find("mrroc: ", named + 1), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(Sensors, FailingSensor,
                         testing::Values(Failure{"dead", "shared", "time", "# mrroc readings tick\n0 0\n150 nan\n", 3,
                                                 "raw value tick is nan"},
                                         Failure{"too_near", "shared", "ultrasonic",
                                                 "# mrroc readings range\n0 1\n150 0.001\n", 1,
                                                 "range 0.001 m, expected at least 0.02 m"},
                                         Failure{"published", "free", "time", "# mrroc readings tick\n0 0\n150 nan\n",
                                                 3, "raw value tick is nan"}),
                         [](const auto& failure) { return std::string(failure.param.name); });

/// Clock, and the sensor that is killed while all clients use it.
class KilledSensor : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(KilledSensor, IsNamedOnceAndTheRestEnds) {
  const auto [clock, sensor] = GetParam();
  const ScratchFolder folder;
  const auto file = folder.write("hold.toml", clients_deployment("hold", kTime, kTime));
  MrrocRun run({"run", file.string(), "--clock", clock});
  for (const auto& [client, period] : kPeriods)
    ASSERT_TRUE(run.wait_for_output(client + " | looks")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  ASSERT_EQ(kill(run.child(sensor), SIGKILL), 0);
  EXPECT_EQ(run.wait(), 4) << run.out() << run.err();
  const std::string line = "mrroc: hold: process " + std::string(sensor) + " died: signal 9 (Killed) [tick ";
  EXPECT_EQ(run.err().substr(0, line.size()), line) << run.err();
  EXPECT_EQ(run.err().find('\n'), run.err().size() - 1) << "once: " << run.err();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(Clocks, KilledSensor,
                         testing::Combine(testing::Values("lockstep", "real"), testing::Values("shared", "free")),
                         [](const auto& test) {
                           return std::string{std::get<0>(test.param)} + "_" + std::get<1>(test.param);
                         });

}  // namespace
}  // namespace mrroc::test::several_clients_errors_test
