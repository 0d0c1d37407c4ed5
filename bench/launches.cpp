#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "mrroc/testing/run.hpp"

using namespace mrroc;

namespace {

struct Deployment {
  const char* name;
  const char* file;
  int one_of;  ///< so many launches
};

const std::vector<Deployment> kDeployments{{"shuttle", "tasks/shuttle/shuttle.toml", 1},
                                           {"press", "tasks/press/press.toml", 5}};

std::string steps_of(const task_test::RunResult& run) {
  std::string lines;
  for (const task_test::Step& step : run.steps) lines.append(step.line).append("\n");
  return lines;
}

/// Launches `deployment` with the seeds from 1 to `launches`. Whether all went well.
bool launch(const Deployment& deployment, int launches) {
  std::string first;
  std::vector<double> times;
  int failed = 0, different = 0;
  std::size_t leftovers = 0;
  for (int seed = 1; seed <= launches; ++seed) {
    const auto begin = std::chrono::steady_clock::now();
    const auto run = task_test::DeploymentRun(MRROC_BINARY_DIR "/bin/mrroc",
                                              std::filesystem::path(MRROC_SOURCE_DIR) / deployment.file)
                         .option("--shuffle-start")
                         .option(std::to_string(seed))
                         .run();
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    leftovers += run.leftovers.size();
    const std::string steps = steps_of(run);
    if (first.empty()) first = steps;
    const bool other = run.exit_code == 0 && (steps.empty() || steps != first);
    if (run.exit_code != 0) ++failed;
    if (other) ++different;
    if (run.exit_code != 0 || other || !run.leftovers.empty())
      std::fprintf(stderr, "%s, seed %d: exit code %d, %zu left%s\n%s\n", deployment.name, seed, run.exit_code,
                   run.leftovers.size(), other ? ", another trace" : "", run.output.c_str());
  }
  std::sort(times.begin(), times.end());
  std::printf("| %s | %d | %d | %d | %zu | %.2f / %.2f |\n", deployment.name, launches, failed, different, leftovers,
              times[times.size() / 2], times.back());
  std::fflush(stdout);
  return failed == 0 && different == 0 && leftovers == 0;
}

}  // namespace

/// launches [COUNT]: launches the task shuttle COUNT (1000) times and press a fifth as often, in lockstep, with the
/// processes in a random order with random delays; the seeds are 1, 2, ... Prints how many failed, had another trace
/// than the first, or left a process; fails when one did.
int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  if (count < 1) return std::fprintf(stderr, "launches [COUNT], COUNT above 0\n"), 2;
  std::printf(
      "| task | launches | failed | with another trace | left | s a launch, p50 / worst "
      "|\n|---|---|---|---|---|---|\n");
  bool good = true;
  for (const Deployment& deployment : kDeployments)
    good = launch(deployment, std::max(1, count / deployment.one_of)) && good;
  return good ? 0 : 1;
}
