#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>

#include "can/bus.hpp"
#include "cli/can/can_frame_formatter.hpp"

namespace mrroc::cli {

struct MonitorOptions {
  std::uint64_t count = std::numeric_limits<std::uint64_t>::max();  ///< frames until it ends
  double seconds = std::numeric_limits<double>::infinity();
  bool summary = false;  ///< one table at the end instead of a line for each frame
  double bit_rate = 1e6;
};

/// Listens until the number of frames or the seconds are reached, or `stop` returns true. Passes to `show` one line for
/// each frame (s since the first frame, then the frame in words), or a summary. Sends nothing. Throws
/// std::runtime_error when the bus is gone, and any exception of `show`.
void monitor(can::Bus& bus, CanFrameFormatter& words, const MonitorOptions& options, const std::function<bool()>& stop,
             const std::function<void(std::string_view text)>& show);

}  // namespace mrroc::cli
