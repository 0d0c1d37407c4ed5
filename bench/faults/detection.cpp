#include "faults/detection.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "mrroc/testing/run.hpp"

namespace mrroc::faults_bench {

namespace {

constexpr double kNoticedWithin = 50;  // ms

/// Threads that compute during the lifetime of this object.
class Load {
 public:
  explicit Load(int threads) {
    for (int i = 0; i < threads; ++i)
      threads_.emplace_back([this] {
        while (!done_.load(std::memory_order_relaxed)) {
        }
      });
  }
  ~Load() {
    done_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  std::atomic<bool> done_ = false;
  std::vector<std::thread> threads_;
};

/// ms; empty: not noticed.
std::vector<double> times_of(const std::string& kind, int seeds) {
  std::vector<double> times;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const auto run = task_test::DeploymentRun(MRROC_BINARY_DIR "/bin/mrroc", MRROC_SOURCE_DIR "/tasks/press/press.toml")
                         .option("--clock")
                         .option("real")
                         .inject(kind + " at tick " + std::to_string(200 + random() % 300))
                         .run();
    constexpr const char* kNotice = "noticed after ";
    if (const std::size_t place = run.output.find(kNotice); place != std::string::npos)
      times.push_back(std::strtod(run.output.c_str() + place + std::char_traits<char>::length(kNotice), nullptr));
    else
      std::fprintf(stderr, "%s: not noticed: %s\n", kind.c_str(), run.output.c_str());
  }
  std::sort(times.begin(), times.end());
  return times;
}

}  // namespace

bool run_detection(int seeds, int load) {
  std::printf("\npress, real clock, beside %d threads that compute: from the signal to the runner's notice, ms, p50 / ",
              load);
  std::printf("worst of %d\n\n| fault | noticed |\n|---|---|\n", seeds);
  const Load computing(load);
  bool all = true;
  for (const std::string action : {"kill", "halt"}) {
    for (const std::string process : {"mp", "ecp:arm", "edp:arm", "vsp:wrist", "sim"}) {
      const std::string kind = action + " " + process;
      const std::vector<double> times = times_of(kind, seeds);
      all = all && times.size() == static_cast<std::size_t>(seeds) && times.back() <= kNoticedWithin;
      if (times.empty())
        std::printf("| %s | - |\n", kind.c_str());
      else
        std::printf("| %s | %.2f / %.2f |\n", kind.c_str(), times[times.size() / 2], times.back());
      std::fflush(stdout);
    }
  }
  return all;
}

}  // namespace mrroc::faults_bench
