#pragma once

#include <cstdint>
#include <vector>

#include "sim/ur/virtual_controller.hpp"

namespace mrroc::sim::ur {

/// The package that the real-time interface sends in each period of the controller, of a CB3 125 times a second: its
/// length (32 bits), then doubles in SI units, big-endian. 1060 bytes of PolyScope 3.2, 1108 from 3.5 on, 1220
/// from 5.10 on. Source: Universal Robots, client interfaces, real-time tables. Under the mutex of the servers.
std::vector<std::uint8_t> realtime_message(const VirtualController& controller);

}  // namespace mrroc::sim::ur
