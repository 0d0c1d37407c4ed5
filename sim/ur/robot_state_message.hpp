#pragma once

#include <cstdint>
#include <vector>

#include "sim/ur/virtual_controller.hpp"

namespace mrroc::sim::ur {

/// The state that the primary and secondary interfaces send ten times a second: a package of kind 16 with the parts
/// robot mode (0), joints (1), tool (2), master board (3), Cartesian state (4) and force mode (7), big-endian, SI
/// units. The robot mode grows with PolyScope 3.2 and 3.5. Source: Universal Robots, client interfaces, tables of 3.15
/// and 5.11. Under the mutex of the servers.
std::vector<std::uint8_t> robot_state_message(const VirtualController& controller);

}  // namespace mrroc::sim::ur
