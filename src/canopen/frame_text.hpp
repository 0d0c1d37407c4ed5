#pragma once

#include <string>

#include "can/frame.hpp"

namespace mrroc::canopen {

/// A one-line description of a frame of a CANopen network: "SYNC", "node 3 heartbeat: operational", "node 3 SDO write
/// 6060h:0 = 08", "node 3 emergency 7305h: incremental sensor 1 fault", "node 3 TPDO 1: 37 16 ...". Frames outside the
/// predefined connection set, and all CAN FD frames, are shown as identifier and bytes; an error frame as the
/// controller's report. The frame may contain any bytes. Not for the real-time path.
std::string to_text(const can::Frame& frame);

}  // namespace mrroc::canopen
