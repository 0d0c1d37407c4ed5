#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include "cooperative_transfer/report/report.hpp"
#include "process/standard_files.hpp"

/// cooperative_transfer_report RECORDING [OUT]: figures of one run. OUT.dat gets the steps, for gnuplot; OUT.txt a tick
/// half way.
int main(int argc, char** argv) {
  mrroc::process::open_standard_files();
  if (argc < 2) return std::fprintf(stderr, "usage: cooperative_transfer_report RECORDING [OUT]\n"), 2;
  try {
    const mrroc::transfer::Report report = mrroc::transfer::read_report(argv[1]);
    constexpr double kDegrees = 57.29577951308232;
    std::printf("bar off its path by at most %.2f mm, %.3f deg (%.2f mm, %.3f deg with the error of the grasp)\n",
                1000 * report.worst_way(), kDegrees * report.worst_turn(), 1000 * report.worst_way_off(),
                kDegrees * report.worst_turn_off());
    std::printf("internal force at most %.2f N, %.2f N RMS, torque at most %.2f N m; skew %llu ticks; %s\n",
                report.worst_internal(), report.rms_internal(), report.worst_internal_torque(),
                static_cast<unsigned long long>(report.skew), report.complete ? "complete" : "NOT complete");
    if (argc > 2) {
      std::ofstream data(std::string{argv[2]} + ".dat"), middle(std::string{argv[2]} + ".txt");
      for (const auto& s : report.steps)
        data << s.time << ' ' << 1000 * s.way << ' ' << kDegrees * s.turn << ' ' << s.internal.norm() << ' '
             << s.internal.transpose() << ' ' << s.internal_torque.transpose() << ' ' << s.weight << ' ' << s.tick
             << '\n';
      middle << report.steps[report.steps.size() / 2].tick << '\n';
    }
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "cooperative_transfer_report: %s\n", error.what()), 1;
  }
}
