#pragma once

#include <string>

#include "can/frame.hpp"

namespace mrroc::canopen {

/// One line that says what a frame of a CANopen network is: "SYNC", "node 3 heartbeat: operational", "node 3 SDO write
/// 6060h:0 = 08", "node 3 emergency 7305h: incremental sensor 1 fault", "node 3 TPDO 1: 37 16 ...". What is no
/// message of the predefined connection set comes as identifier and bytes, also every frame of CAN FD; an error frame
/// as what the controller reports. Any bytes whatsoever may be in it. Not for the real-time path.
std::string to_text(const can::Frame& frame);

}  // namespace mrroc::canopen
