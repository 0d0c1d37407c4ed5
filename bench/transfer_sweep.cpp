#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "cooperative_transfer/report/report.hpp"
#include "cooperative_transfer/report/variant.hpp"

using namespace mrroc::transfer;

namespace {

constexpr double kDegrees = 57.29577951308232;

struct Worst {
  double way = 0, turn = 0, way_off = 0, turn_off = 0, internal = 0, rms = 0;
  std::uint64_t skew = 0;
  int complete = 0;
  void add(const Report& r) {
    way = std::max(way, 1000 * r.worst_way());
    turn = std::max(turn, kDegrees * r.worst_turn());
    way_off = std::max(way_off, 1000 * r.worst_way_off());
    turn_off = std::max(turn_off, kDegrees * r.worst_turn_off());
    internal = std::max(internal, r.worst_internal());
    rms = std::max(rms, r.rms_internal());
    skew = std::max(skew, r.skew);
    complete += r.complete ? 1 : 0;
  }
  void print(const char* mass, const char* seed) const {
    std::printf("%5s %5s  %8d  %8.3f %8.3f  %8.3f %8.3f  %8.2f %8.2f  %4llu\n", mass, seed, complete, way, turn,
                way_off, turn_off, internal, rms, static_cast<unsigned long long>(skew));
    std::fflush(stdout);
  }
};

}  // namespace

/// transfer_sweep [SEEDS [MASS ...]]: runs the task cooperative_transfer with every mass (kg; 0.5 1 2 3) and seeds 1 to
/// SEEDS (20) of the initial error of the grasp. Prints the outcome of every run and the worst of every mass. Fails
/// when a run failed.
int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  std::vector<double> masses;
  for (int i = 2; i < argc; ++i) masses.push_back(std::atof(argv[i]));
  if (masses.empty()) masses = {0.5, 1, 2, 3};
  std::string pattern = std::filesystem::temp_directory_path() / "mrroc_transfer_XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) return std::perror("mkdtemp"), 1;
  const std::filesystem::path folder = pattern, trace = folder / "run.mcap";
  bool good = true;
  std::printf("   kg  seed  complete  off mm  off deg   with the error of the grasp  internal N  RMS   skew\n");
  for (const double mass : masses) {
    std::array<char, 32> mass_text{};
    std::snprintf(mass_text.data(), mass_text.size(), "%g", mass);
    Worst all;
    for (int seed = 1; seed <= seeds; ++seed) {
      const auto file = write_variant({mass, Variant::error_of(static_cast<unsigned>(seed))}, folder);
      const std::string command = std::string{MRROC_BINARY_DIR} + "/bin/mrroc run " + file.string() +
                                  " --quiet --clock lockstep --record " + trace.string();
      const bool ran = std::system(command.c_str()) == 0;
      good = good && ran;
      try {
        const Report report = read_report(trace);
        Worst one;
        one.add(report);
        one.print(mass_text.data(), std::to_string(seed).c_str());
        all.add(report);
      } catch (const std::exception& error) {
        std::printf("%5s %5d  %s\n", mass_text.data(), seed, error.what());
        good = false;
      }
    }
    all.print(mass_text.data(), "all");
    good = good && all.complete == seeds;
  }
  std::filesystem::remove_all(folder);
  return good ? 0 : 1;
}
