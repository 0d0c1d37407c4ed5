#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "mrroc/testing/run.hpp"

using namespace mrroc;

namespace {

/// A task, and the faults that are injected into it.
struct Campaign {
  const char* name;
  const char* deployment;
  std::vector<const char*> faults;
  bool everywhere = true;  ///< else it is run when it is named only
};

const std::vector<Campaign> kCampaigns{
    {"press",
     "tasks/press/press.toml",
     {"kill mp",
      "kill ecp:arm",
      "kill edp:arm",
      "kill vsp:wrist",
      "kill vsp:gate",
      "kill sim",
      "halt mp",
      "halt ecp:arm",
      "halt edp:arm",
      "halt vsp:wrist",
      "halt sim",
      "end ecp:arm",
      "end edp:arm",
      "fault edp:arm",
      "silence edp:arm",
      "unreference edp:arm",
      "jump edp:arm axis 2 by 3",
      "freeze edp:arm axis 2",
      "freeze edp:arm axis 4",
      "freeze edp:arm axis 5",
      "nan edp:arm axis 2",
      "overload edp:arm axis 2",
      "disconnect edp:arm axis 2",
      "runaway edp:arm axis 2",
      "silence vsp:wrist",
      "jump vsp:wrist by 200",
      "nan vsp:wrist",
      "lose ecp:arm",
      "delay ecp:arm by 40",
      "corrupt ecp:arm",
      "leap ecp:arm"}},
    {"cooperative_transfer",
     "tasks/cooperative_transfer/cooperative_transfer.toml",
     {"kill mp",
      "kill ecp:left",
      "kill edp:left",
      "kill vsp:left_wrist",
      "kill sim",
      "halt mp",
      "halt ecp:left",
      "halt edp:left",
      "halt sim",
      "end ecp:left",
      "fault edp:left",
      "silence edp:left",
      "unreference edp:left",
      "jump edp:left axis 2 by 3",
      "freeze edp:left axis 2",
      "freeze edp:left axis 4",
      "freeze edp:left axis 5",
      "nan edp:left axis 2",
      "disconnect edp:left axis 2",
      "runaway edp:left axis 2",
      "silence vsp:left_wrist",
      "jump vsp:left_wrist by 200",
      "lose mp",
      "corrupt mp",
      "leap mp"}},
    // needs an interface can0: tests/can/with_can -- build/bench/faults 20 press_can
    {"press_can",
     "tasks/press/press_can.toml",
     {"kill edp:arm", "kill drives:arm", "halt edp:arm", "halt drives:arm", "fault drives:arm axis 2",
      "silence drives:arm axis 2", "freeze drives:arm axis 2", "restart drives:arm axis 2", "hush drives:arm axis 2"},
     false},
};

/// The last "tick <number>" in a text that is not before `first`; nothing else tells when the error was found.
std::optional<Tick> tick_in(const std::string& text, Tick first) {
  std::optional<Tick> found;
  for (std::size_t place = text.find("tick "); place != std::string::npos; place = text.find("tick ", place + 1)) {
    const Tick tick = std::strtoull(text.c_str() + place + 5, nullptr, 10);
    if (tick >= first) found = found ? std::min(*found, tick) : tick;
  }
  return found;
}

/// What the runs of one fault came to.
struct Row {
  std::vector<Tick> detected;  ///< ticks from the fault to the first error or the end of the run that names it
  std::vector<Tick> standing;  ///< ticks from then to the standstill of the last robot
  double fastest = 0;          ///< joint, as a part of its limit
  std::size_t runs = 0, unseen = 0, unaffected = 0, early = 0, exceeded = 0, moving = 0, leftovers = 0;
  std::set<int> exit_codes;
  std::string error;

  static std::string figures(std::vector<Tick> ticks) {
    if (ticks.empty()) return "-";
    std::sort(ticks.begin(), ticks.end());
    return std::to_string(ticks[ticks.size() / 2]).append(" / ").append(std::to_string(ticks.back()));
  }
  void print(const std::string& fault) const {
    std::string codes;
    for (const int code : exit_codes) codes.append(codes.empty() ? "" : " ").append(std::to_string(code));
    std::printf("| %s | %zu | %s | %s | %.2f | %zu | %zu | %s | %s | %zu |\n", fault.c_str(), runs,
                figures(detected).c_str(), figures(standing).c_str(), fastest, exceeded, unaffected, codes.c_str(),
                error.c_str(), leftovers);
    std::fflush(stdout);
  }
};

/// The line that tells why, without the deployment's name and what belongs to one case: "hardware error: the following
/// error is too large", "process arm died".
std::string class_of(const task_test::RunResult& run) {
  std::vector<std::string> parts;
  for (std::size_t place = 0; place < run.error.size();) {
    const std::size_t end = std::min(run.error.find(": ", place), run.error.size());
    parts.push_back(run.error.substr(place, end - place));
    place = end + 2;
  }
  if (parts.size() < 2) return run.error;
  const bool process = parts[1].starts_with("process ");
  return process || parts.size() < 3 ? parts[1].substr(0, parts[1].find(" by "))
                                     : parts[1].append(": ").append(parts[2]);
}

void add(Row& row, const task_test::RunResult& run, const std::string& fault) {
  ++row.runs;
  row.exit_codes.insert(run.exit_code);
  row.leftovers += run.leftovers.size();
  const auto injected = run.injected.find(fault);
  if (injected == run.injected.end() || run.exit_code == 0) {
    ++row.unaffected;  // it ended before, or went on in spite of it
    if (run.exit_code != 0) {
      ++row.early;
      std::fprintf(stderr, "%s: ended before it: %s\n", fault.c_str(), run.output.c_str());
    }
  } else {
    row.error = class_of(run);
    std::string told = run.output;  // without the line that says when it was injected
    if (const std::size_t place = told.find("injected at tick "); place != std::string::npos)
      told.erase(place, told.find('\n', place) - place);
    // a process that dies at the beginning of a tick is missed at once: the tick before is the newest that all have
    // seen
    if (const auto detected = tick_in(told, injected->second - 1))
      row.detected.push_back(std::max(*detected, injected->second) - injected->second);
  }
  if (run.motion.empty()) ++row.unseen;
  const Tick from = injected == run.injected.end() ? 0 : injected->second;
  Tick stands = 0;
  for (const auto& [robot, motion] : run.motion) {
    row.exceeded += motion.limits_exceeded().size();
    row.fastest = std::max(row.fastest, motion.fastest());
    const Tick tick = motion.standstill();
    if (tick == kNever) ++row.moving;
    stands = std::max(stands, tick);
  }
  if (run.exit_code != 0 && stands != kNever && injected != run.injected.end())
    row.standing.push_back(stands > from ? stands - from : 0);
}

Tick length_of(const std::filesystem::path& deployment) {
  const auto run = task_test::DeploymentRun(MRROC_BINARY_DIR "/bin/mrroc", deployment).run();
  Tick last = 0;
  for (const task_test::Step& step : run.steps) last = std::max(last, step.tick);
  if (run.exit_code != 0) std::printf("without a fault it ends with %d: %s\n", run.exit_code, run.output.c_str());
  return last;
}

bool run_campaign(const Campaign& campaign, int seeds, const std::string& beginning) {
  const std::filesystem::path deployment = std::filesystem::path(MRROC_SOURCE_DIR) / campaign.deployment;
  const Tick length = length_of(deployment);
  if (length == 0) return false;
  std::printf("\n%s, %llu ticks without a fault; ticks are p50 / worst\n\n", campaign.name,
              static_cast<unsigned long long>(length));
  std::printf(
      "| fault | runs | to its detection | to standstill | fastest, of the limit | beyond a limit | unaffected | exit "
      "codes | error | left "
      "|\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const std::string kind : campaign.faults) {
    if (!kind.starts_with(beginning)) continue;
    Row row;
    for (int seed = 1; seed <= seeds; ++seed) {
      std::mt19937_64 random(static_cast<std::uint64_t>(seed));
      const Tick tick = length / 20 + random() % (length * 9 / 10);
      const std::string lasting = kind.starts_with("delay") ? " for 100 ticks" : "";
      const std::string fault = kind + " at tick " + std::to_string(tick) + lasting;
      add(row, task_test::DeploymentRun(MRROC_BINARY_DIR "/bin/mrroc", deployment).inject(fault).run(), fault);
    }
    row.print(kind);
    const bool world_ends = kind.ends_with(" sim");  // with its robots as they moved
    good = good && row.unseen == 0 && row.early == 0 && row.exceeded == 0 && (world_ends || row.moving == 0) &&
           row.leftovers == 0;
  }
  return good;
}

/// Under the real clock: wall time from the signal to the runner's knowing. False: one was not noticed.
bool run_detection(int seeds) {
  constexpr double kNoticedWithin = 50;  // ms
  std::printf("\npress, real clock: from the signal to the runner's notice, ms, p50 / worst of %d\n\n", seeds);
  std::printf("| fault | noticed |\n|---|---|\n");
  bool all = true;
  for (const std::string kind :
       {"kill mp", "kill ecp:arm", "kill edp:arm", "halt mp", "halt ecp:arm", "halt edp:arm"}) {
    std::vector<double> times;
    for (int seed = 1; seed <= seeds; ++seed) {
      std::mt19937_64 random(static_cast<std::uint64_t>(seed));
      const std::string fault = kind + " at tick " + std::to_string(200 + random() % 300);
      const auto run =
          task_test::DeploymentRun(MRROC_BINARY_DIR "/bin/mrroc", MRROC_SOURCE_DIR "/tasks/press/press.toml")
              .option("--clock")
              .option("real")
              .inject(fault)
              .run();
      const std::size_t place = run.output.find("noticed after ");
      if (place != std::string::npos) times.push_back(std::strtod(run.output.c_str() + place + 14, nullptr));
    }
    std::sort(times.begin(), times.end());
    all = all && times.size() == static_cast<std::size_t>(seeds) && times.back() <= kNoticedWithin;
    if (times.empty())
      std::printf("| %s | - |\n", kind.c_str());
    else
      std::printf("| %s | %.2f / %.2f |\n", kind.c_str(), times[times.size() / 2], times.back());
    std::fflush(stdout);
  }
  return all;
}

}  // namespace

/// faults [SEEDS [TASK [BEGINNING] | real]]: injects every kind of fault at SEEDS (20) random ticks of the tasks press
/// and cooperative_transfer, or of press_can over an interface can0, in lockstep, or those whose names have this
/// beginning, and prints what came of it; then how long the runner takes to notice a dead or halted process under the
/// real clock. Fails when a robot has exceeded a limit or moved to the end or was not seen at all, a process was left,
/// or a death was not noticed within 50 ms.
int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  const std::string only = argc > 2 ? argv[2] : "";
  const std::string beginning = argc > 3 ? argv[3] : "";
  bool good = true, any = only.empty() || only == "real";
  for (const Campaign& campaign : kCampaigns) {
    if (only.empty() ? !campaign.everywhere : only != campaign.name) continue;
    good = run_campaign(campaign, seeds, beginning) && good;
    any = true;
  }
  if (only.empty() || only == "real") good = run_detection(seeds) && good;
  if (!any)
    std::fprintf(stderr, "faults: no task '%s', expected press, cooperative_transfer, press_can or real\n",
                 only.c_str());
  return good && any ? 0 : 1;
}
