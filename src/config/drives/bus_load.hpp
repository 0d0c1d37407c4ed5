#pragma once

#include "config/drives/drive_table.hpp"
#include "config/drives/io_table.hpp"

namespace mrroc::config {

/// Bits of a classical frame with `data` bytes, as long as bit stuffing can make it, with the space between frames:
/// 8 n + 47 + floor((34 + 8 n - 1) / 4) (R. I. Davis et al., "Controller Area Network (CAN) schedulability analysis:
/// Refuted, revisited and revised", Real-Time Systems 35, 2007).
constexpr int frame_bits(int data) noexcept { return 8 * data + 47 + (34 + 8 * data - 1) / 4; }

/// What the nodes of one robot take of a bus, docs/how-to/can.md. Loads of robots on one bus are added.
struct BusLoad {
  double cycle = 0;       ///< bits of one cycle: SYNC, answers and set-points, without what can come later
  double per_second = 0;  ///< bits of everything
};

/// `period`: servo period, s.
BusLoad bus_load(const DriveTable& drives, const IoTable& io, double period);

}  // namespace mrroc::config
