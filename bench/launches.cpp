#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "mrroc/testing/run.hpp"

using namespace mrroc;

namespace {

struct Deployment {
  const char* name;
  const char* file;
  int one_of;  ///< its share of the launches: one of so many
};

const std::vector<Deployment> kDeployments{{"shuttle", "tasks/shuttle/shuttle.toml", 1},
                                           {"press", "tasks/press/press.toml", 5}};

std::string steps_of(const task_test::RunResult& run) {
  std::string lines;
  for (const task_test::Step& step : run.steps) lines.append(step.json).append("\n");
  return lines;
}

/// Launches of one deployment with the seeds 1, 2, ..., several at a time.
class Launches {
 public:
  Launches(const Deployment& deployment, int count) : deployment_(deployment), count_(count) {}

  /// Whether all launches succeeded.
  bool run(int together) {
    std::vector<std::thread> threads;
    for (int i = 0; i < together; ++i)
      threads.emplace_back([this] {
        for (int seed = ++next_; seed <= count_; seed = ++next_) launch(seed);
      });
    for (std::thread& thread : threads) thread.join();
    std::sort(times_.begin(), times_.end());
    std::printf("| %s | %d | %d | %d | %zu | %.2f / %.2f |\n", deployment_.name, count_, failed_, different_,
                leftovers_, times_[times_.size() / 2], times_.back());
    std::fflush(stdout);
    return failed_ == 0 && different_ == 0 && leftovers_ == 0;
  }

 private:
  void launch(int seed) {
    const auto begin = std::chrono::steady_clock::now();
    const auto run = task_test::DeploymentRun(MRROC_BINARY_DIR "/bin/mrroc",
                                              std::filesystem::path(MRROC_SOURCE_DIR) / deployment_.file)
                         .option("--shuffle-start")
                         .option(std::to_string(seed))
                         .run();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::string steps = steps_of(run);
    const std::lock_guard lock(mutex_);
    times_.push_back(seconds);
    leftovers_ += run.leftovers.size();
    if (first_.empty()) first_ = steps;
    const bool other = run.exit_code == 0 && (steps.empty() || steps != first_);
    if (run.exit_code != 0) ++failed_;
    if (other) ++different_;
    if (run.exit_code != 0 || other || !run.leftovers.empty())
      std::fprintf(stderr, "%s, seed %d: exit code %d, %zu left%s\n%s\n", deployment_.name, seed, run.exit_code,
                   run.leftovers.size(), other ? ", another trace" : "", run.output.c_str());
  }

  const Deployment& deployment_;
  const int count_;
  std::atomic<int> next_{0};
  std::mutex mutex_;  // guards the members below
  std::string first_;
  std::vector<double> times_;
  int failed_ = 0, different_ = 0;
  std::size_t leftovers_ = 0;
};

}  // namespace

/// launches [COUNT [TOGETHER]]: launches the task shuttle COUNT (1000) times and press a fifth as often, TOGETHER (4)
/// at a time, in lockstep, with the processes in a random order with random delays; the seeds are 1, 2, ... Prints how
/// many failed, had another trace than the first, or left a process behind; fails when one did.
int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int together = argc > 2 ? std::atoi(argv[2]) : 4;
  if (count < 1 || together < 1) return std::fprintf(stderr, "launches [COUNT [TOGETHER]], both above 0\n"), 2;
  std::printf(
      "| task | launches | failed | with another trace | left | s a launch, p50 / worst "
      "|\n|---|---|---|---|---|---|\n");
  bool good = true;
  for (const Deployment& deployment : kDeployments)
    good = Launches(deployment, std::max(1, count / deployment.one_of)).run(together) && good;
  return good ? 0 : 1;
}
