#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "faults/campaign.hpp"
#include "faults/detection.hpp"
#include "faults/row.hpp"

using namespace mrroc;
using namespace mrroc::faults_bench;

namespace {

/// Length of a run without a fault, in ticks; 0: it does not reach its end.
Tick length_of(const Campaign& campaign) {
  const auto run = task_test::DeploymentRun(MRROC_BINARY_DIR "/bin/mrroc", campaign.deployment).run();
  Tick last = 0;
  for (const task_test::Step& step : run.steps) last = std::max(last, step.tick);
  if (run.exit_code == 0) return last;
  std::fprintf(stderr, "%s ends with %d without a fault: %s\n", campaign.name.c_str(), run.exit_code,
               run.output.c_str());
  return 0;
}

/// The fault at this tick: "delay ecp:arm by 40 at tick 120 for 100 ticks".
std::string at(Tick tick, const std::string& fault) {
  const std::size_t lasting = std::min(fault.find(" for "), fault.size());
  return fault.substr(0, lasting) + " at tick " + std::to_string(tick) + fault.substr(lasting);
}

bool run_campaign(const Campaign& campaign, int seeds, const std::string& beginning) {
  const Tick length = length_of(campaign);
  if (length == 0) return false;
  std::printf("\n%s, %llu ticks without a fault; %d runs of each, ticks are p50 / worst\n\n", campaign.name.c_str(),
              static_cast<unsigned long long>(length), seeds);
  Row::print_head();
  bool good = true;
  for (const std::string& fault : campaign.faults) {
    if (!fault.starts_with(beginning)) continue;
    Row row(fault);
    for (int seed = 1; seed <= seeds; ++seed) {
      std::mt19937_64 random(static_cast<std::uint64_t>(seed));
      const std::string injected = at(length / 20 + random() % (length * 9 / 10), fault);
      row.add(task_test::DeploymentRun(MRROC_BINARY_DIR "/bin/mrroc", campaign.deployment).inject(injected).run(),
              injected);
    }
    row.print();
    // a frozen encoder jumps when it returns: its axis may need synchronisation
    good = row.good(campaign.recovers && !fault.starts_with("freeze")) && good;
  }
  return good;
}

}  // namespace

/// faults [SEEDS [TASK [BEGINNING] | real | loaded]]: injects every kind of fault, or those whose names start with
/// BEGINNING, at SEEDS (20) random ticks of the tasks press, cooperative_transfer and recovering, or of press_can or
/// recovering_can over an interface can0, in lockstep. Prints the outcome, then how long the runner takes to report a
/// dead or stopped process under the real clock, without load and beside four threads that compute. Fails when a robot
/// exceeded a limit, moved to the end or was not recorded, a process remained, recovering or recovering_can did not
/// reach its end (a frozen encoder may end it), or a death was not reported within 50 ms.
int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  const std::string only = argc > 2 ? argv[2] : "";
  const std::string beginning = argc > 3 ? argv[3] : "";
  bool good = true, any = false;
  for (const Campaign& campaign : campaigns()) {
    if (only.empty() ? !campaign.everywhere : only != campaign.name) continue;
    good = run_campaign(campaign, seeds, beginning) && good;
    any = true;
  }
  for (const auto& [name, load] : {std::pair{"real", 0}, {"loaded", 4}}) {
    if (!only.empty() && only != name) continue;
    good = run_detection(seeds, load) && good;
    any = true;
  }
  if (!any)
    std::fprintf(
        stderr,
        "faults: no task '%s', expected press, cooperative_transfer, recovering, press_can, recovering_can, real or "
        "loaded\n",
        only.c_str());
  return good && any ? 0 : 1;
}
