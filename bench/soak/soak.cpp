#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "soak/soak_run.hpp"

using namespace mrroc::soak;

namespace {

/// Permitted growth of a process since the first eighth of the time, KiB, without the receive buffers. One byte kept
/// per step would be 630 in four hours. Work that is done for the first time costs some: a new grip up to 112 in the
/// MP.
constexpr long kGrowth = 256;
/// KiB of the runner for each second of the run: the index of the recording, which has a chunk for each.
constexpr double kIndex = 1;
/// KiB that the largest process may ever have had more than at a lap: the runner writes the index of
/// the recording at the end.
constexpr long kPeak = 16384;
constexpr std::size_t kServos = 4;

const Sample& settled(const SoakRun& run) {
  const double from = run.samples.back().time / 8;
  return *std::find_if(run.samples.begin(), run.samples.end(), [&](const Sample& s) { return s.time >= from; });
}

/// Whether no process has grown.
bool print_memory(const SoakRun& run) {
  if (run.samples.empty()) return std::printf("no lap was ended\n"), false;
  const Sample &first = settled(run), &last = run.samples.back();
  std::printf(
      "KiB\n| process | after %.0f s | after %.0f s | growth | without receive buffers |\n|---|---|---|---|---|\n",
      first.time, last.time);
  bool good = first.resident.size() == last.resident.size();
  long largest = 0;
  for (const auto& [process, size] : last.resident) {
    const auto before = first.resident.find(process);
    if (before == first.resident.end()) return std::printf("%s was not there at first\n", process.c_str()), false;
    const long growth = size.others - before->second.others;
    std::printf("| %s | %ld | %ld | %ld | %ld |\n", process.c_str(), before->second.sum(), size.sum(),
                size.sum() - before->second.sum(), growth);
    const double index = process == "runner" ? kIndex * (last.time - first.time) : 0;
    good = good && size.others > 0 && static_cast<double>(growth) <= kGrowth + index;
    largest = std::max(largest, size.sum());
  }
  std::printf("the most that any had at any time: %ld KiB\n", run.peak);
  return good && run.peak <= largest + kPeak;
}

bool print(const SoakRun& run) {
  std::printf("%s%s\n", run.output.c_str(), run.summary.c_str());
  std::printf("exit code %d, %zu laps, %llu steps, skew %llu; %zu servos: %llu ticks, %llu missed, %llu late\n",
              run.exit_code, run.samples.size(), static_cast<unsigned long long>(run.steps),
              static_cast<unsigned long long>(run.skew), run.servos, static_cast<unsigned long long>(run.ticks),
              static_cast<unsigned long long>(run.missed), static_cast<unsigned long long>(run.late));
  std::printf("recording %s, %.1f MB\n", run.hash.c_str(), static_cast<double>(run.trace_bytes) / 1e6);
  const bool level = print_memory(run);
  std::fflush(stdout);
  return run.exit_code == 0 && level && run.servos == kServos && run.missed == 0 && run.late == 0 && run.skew == 0;
}

}  // namespace

/// soak [HOURS] [--twice]: carries the bar of the task cooperative_transfer forth and back for HOURS (4) of simulated
/// time in lockstep, and prints the figures of ticks, commands and memory. Fails when the bar was lost, a tick missed,
/// a command late or a process has grown; with --twice also when a second run has another trace.
int main(int argc, char** argv) try {
  double hours = 4;
  int runs = 1;
  for (int i = 1; i < argc; ++i) {
    if (std::string{argv[i]} == "--twice")
      runs = 2;
    else
      hours = std::atof(argv[i]);
  }
  if (!(hours > 0)) return std::fprintf(stderr, "soak [HOURS] [--twice], HOURS above 0\n"), 2;
  bool good = true;
  std::vector<std::string> hashes;
  for (int i = 0; i < runs; ++i) {
    const SoakRun run = soak(3600 * hours);
    good = print(run) && good;
    hashes.push_back(run.hash);
  }
  const bool equal = hashes.front() == hashes.back();
  if (runs > 1) std::printf("the traces are %s\n", equal ? "equal" : "DIFFERENT");
  std::printf("%s\n", good && equal ? "all held" : "NOT ALL HELD");
  return good && equal ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "soak: %s\n", error.what());
  return 1;
}
