// Bits of the frames that the driver `socketcan` and its drives exchange, measured: each frame with its own stuff bits,
// mode by mode and for 1 to 8 axes, and the load that they make at a servo period of 2 ms.
#include <algorithm>
#include <cstdio>

#include "config/drives/bus_load.hpp"
#include "drivers/socketcan/frame_length.hpp"
#include "drivers/socketcan/traffic.hpp"

namespace {

using namespace mrroc;
using canopen::DriveMode;

constexpr int kCycles = 400;
constexpr int kBitRates[] = {1'000'000, 500'000, 250'000, 125'000};

/// One line: what was counted, and at each bit rate the mean load and its bound.
void measure(const char* name, DriveMode mode, int axes) {
  edp::Traffic traffic(axes, mode);
  double sum = 0, frames = 0;
  int most = 0;
  for (int i = 0; i < kCycles; ++i) {
    int bits = 0;
    for (const can::Frame& frame : traffic.cycle()) {
      bits += can::frame_length(frame);
      ++frames;
    }
    sum += bits;
    most = std::max(most, bits);
  }
  const double bound = config::bus_load(traffic.table(), {}, edp::kCanPeriod).per_second;
  const double heartbeats = (axes + 1) * config::frame_bits(1) / traffic.table().heartbeat;
  const double mean = sum / kCycles / edp::kCanPeriod + heartbeats;
  std::printf("| %s | %d | %.2f | %.0f | %d |", name, axes, frames / kCycles, sum / kCycles, most);
  for (const int rate : kBitRates) {
    if (bound > rate)
      std::printf(" - |");
    else
      std::printf(" %.0f, %.0f %% |", 100 * mean / rate, 100 * bound / rate);
  }
  std::printf("\n");
}

}  // namespace

int main() {
  std::puts("| mode | axes | frames | mean bits | most bits | 1000 kbit/s | 500 kbit/s | 250 kbit/s | 125 kbit/s |");
  std::puts("|---|---|---|---|---|---|---|---|---|");
  for (const auto& [name, mode] : {std::pair{"position", DriveMode::cyclic_position},
                                   {"velocity", DriveMode::cyclic_velocity},
                                   {"torque", DriveMode::cyclic_torque}})
    for (int axes = 1; axes <= 8; ++axes) measure(name, mode, axes);
}
