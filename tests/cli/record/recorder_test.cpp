#include "cli/record/recorder.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/trace/encoded_line.hpp"
#include "cli/trace/trace_steps.hpp"
#include "clock/thread_deployment.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::recorder_test {
namespace {

using Made = std::pair<Tick, std::string>;

process::EncodedStep step_of(const std::string& process) {
  const trace::TraceSteps example = trace::example_trace();
  for (std::size_t i = 0; i < example.items.size(); ++i)
    if (example.is_line(i) && example.line(i).process == process) return trace::encoded_line(example.line(i));
  throw std::logic_error("no step of " + process);
}

std::vector<Made> steps_in(const std::filesystem::path& file) {
  std::vector<Made> steps;
  const trace::TraceSteps read = trace::read_trace(file);
  for (std::size_t i = 0; i < read.items.size(); ++i)
    if (read.is_line(i)) steps.emplace_back(read.line(i).made, read.line(i).process);
  return steps;
}

/// Two tasks in lockstep that are stopped before tick 100; "arm", the first by name, says how it ended when time has
/// advanced without it.
TEST(Recorder, LastStepOfASlowTaskKeepsItsPlace) {
  constexpr Tick kStop = 100;
  const task_test::ScratchFolder folder;
  const process::ClaimedFile file(folder / "run.mcap", "the recording");
  config::Deployment deployment;
  deployment.name = "t";
  deployment.clock = config::ClockMode::lockstep;
  const std::vector<PlannedProcess> plan = {{.name = "arm", .program = {}, .has_task = true},
                                            {.name = "mp", .program = {}, .has_task = true}};
  const std::string text = "[deployment]\nname = \"t\"\n";
  const std::vector<std::string> faults;

  clock::ThreadDeployment threads({"arm", "mp", "drives"});
  record::Recorder recorder(file, {deployment, plan, text, faults, threads.host});
  std::atomic<bool> written{false};
  threads.add("arm", [&](clock::Clock& clock) {
    process::StepRing ring = process::StepRing::attach(recorder.fd_of("arm"));
    EXPECT_EQ(clock.wait(kNever), clock::Wake::interrupted);
    while (!written.load()) std::this_thread::yield();
    ring.add(clock.tick(), step_of("arm"), true);
    ring.end();
  });
  threads.add("mp", [&](clock::Clock& clock) {
    process::StepRing ring = process::StepRing::attach(recorder.fd_of("mp"));
    const process::EncodedStep step = step_of("mp");
    while (clock.wait(clock.tick() + 1) == clock::Wake::tick) ring.add(clock.tick(), step, true);
    ring.end();
  });
  threads.add(
      "drives",
      [&](clock::Clock& clock) {
        while (clock.tick() < kStop + 50) clock.wait(clock.tick() + 1);
        std::this_thread::sleep_for(std::chrono::milliseconds{50});  // of the recorder: it has seen this tick
        written.store(true);
      },
      clock::Part::drives);
  threads.host.at_tick(kStop, [&](Tick) { threads.host.stop(); });
  threads.start();
  threads.join();
  EXPECT_EQ(recorder.close({}), "");

  std::vector<Made> expected;
  for (Tick tick = 1; tick < kStop; ++tick) {
    if (tick == kStop - 1) expected.emplace_back(tick, "arm");
    expected.emplace_back(tick, "mp");
  }
  EXPECT_EQ(steps_in(folder / "run.mcap"), expected);
}

}  // namespace
}  // namespace mrroc::cli::recorder_test
