#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "privileges.hpp"
#include "system/hosts/cable.hpp"
#include "system/mrroc_run.hpp"

using namespace mrroc::test;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kNoticedWithin = 50;  // ms

/// press_mp with its MP here and everything else on host b, with the usual link_timeout.
std::string deployment(const Cable& cable) {
  std::string command;
  for (const std::string& word : cable.b().command()) command += (command.empty() ? "\"" : ", \"") + word + "\"";
  return std::string{"[deployment]\nname = \"cable\"\nclock = \"real\"\n[network]\ninterface = \""} + Cable::kDevice +
         "\"\nkeys = \"keys\"\n[hosts.cell]\naddress = \"" + Cable::kAddressOfB + "\"\ncommand = [" + command +
         "]\n[mp]\nprogram = \"press_mp\"\n"
         "[robots.arm]\ntype = \"irb6\"\nhardware = \"mujoco\"\nhost = \"cell\"\nposition = [0.0, 0.0, 0.7]\n"
         "[sensors.wrist]\ntype = \"force_torque\"\nrobot = \"arm\"\n"
         "[sensors.gate]\ntype = \"ultrasonic\"\nmode = \"non-interactive\"\nrate = 50\n"
         "[sim]\nscene = \"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"\n";
}

struct Fault {
  const char* name;
  std::function<void(Cable&, const MrrocRun&)> strike;
  const char* notice;  ///< the runner's message about it
};

void signal_process(const MrrocRun& run, const char* name, int number) { kill(run.descendant(name), number); }
void signal_agent(const MrrocRun& run, int number) { kill(parent_of(run.descendant("arm_edp")), number); }

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all{
      {"cut cable", [](Cable& cable, const MrrocRun&) { cable.set({.cut = true}); }, "link lost"},
      {"kill agent", [](Cable&, const MrrocRun& run) { signal_agent(run, SIGKILL); }, "host cell: "},
      {"halt agent", [](Cable&, const MrrocRun& run) { signal_agent(run, SIGSTOP); }, "link lost"},
      {"kill edp:arm", [](Cable&, const MrrocRun& run) { signal_process(run, "arm_edp", SIGKILL); }, "on host cell "},
      {"halt edp:arm", [](Cable&, const MrrocRun& run) { signal_process(run, "arm_edp", SIGSTOP); }, "on host cell "},
      {"kill sim", [](Cable&, const MrrocRun& run) { signal_process(run, "sim", SIGKILL); }, "on host cell "},
      {"kill mp", [](Cable&, const MrrocRun& run) { signal_process(run, "mp", SIGKILL); }, "process mp "},
  };
  return all;
}

/// ms from the fault to the runner's message; empty: there is no message, or the task has not begun.
std::optional<double> time_of(const Fault& fault, std::uint64_t seed) {
  const ScratchFolder folder;
  Cable cable(seed);
  run_mrroc({"keys", (folder.path() / "keys").string()}, 0);
  std::mt19937_64 random(seed);
  const auto file = folder.write("cable.toml", deployment(cable));
  std::optional<MrrocRun> run;
  {
    const Inside inside(cable.a());
    run.emplace(std::vector<std::string>{"run", file.string()});
  }
  if (!run->wait_for_output("closer than")) return std::nullopt;  // from here on the arm moves
  std::this_thread::sleep_for(std::chrono::milliseconds{random() % 3000});
  const auto begin = Clock::now();
  fault.strike(cable, *run);
  while (run->err().find(fault.notice) == std::string::npos) {
    const double waited = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    if (waited > 10'000) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::microseconds{200});
  }
  const double noticed = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  run->wait();
  return noticed;
}

}  // namespace

/// cable_detection [SEEDS]: runs press_mp with the MP on one host and everything else on another (network namespaces
/// with a cable, as root or in a user namespace), with keys, under the real clock. Cuts the cable, or kills or stops a
/// process of either host, SEEDS (20) times each at a random moment. Prints the wall time until `mrroc run` reports the
/// fault. Fails when a fault is not reported within 50 ms.
int main(int argc, char** argv) {
  enter_own_network();
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  std::printf(
      "two hosts, real clock: to the runner's notice, ms, p50 / worst of %d\n\n| fault | noticed |\n|---|---|\n",
      seeds);
  bool good = true;
  for (const Fault& fault : faults()) {
    std::vector<double> times;
    for (int seed = 1; seed <= seeds; ++seed)
      if (const auto time = time_of(fault, static_cast<std::uint64_t>(seed))) times.push_back(*time);
    std::sort(times.begin(), times.end());
    good = good && times.size() == static_cast<std::size_t>(seeds) && times.back() <= kNoticedWithin;
    if (times.empty())
      std::printf("| %s | - |\n", fault.name);
    else
      std::printf("| %s | %.2f / %.2f%s |\n", fault.name, times[times.size() / 2], times.back(),
                  times.size() < static_cast<std::size_t>(seeds) ? ", others not" : "");
    std::fflush(stdout);
  }
  return good ? 0 : 1;
}
