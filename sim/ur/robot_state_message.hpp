#pragma once

#include <cstdint>
#include <vector>

#include "sim/ur/virtual_controller.hpp"

namespace mrroc::sim::ur {

/// The state that the primary and secondary interfaces send ten times a second: the parts "robot mode" and "joints" of
/// a package of kind 16, big-endian; joints in rad and rad/s. Source: Universal Robots, remote control via TCP/IP.
/// Under the mutex of the servers.
std::vector<std::uint8_t> robot_state_message(const VirtualController& controller);

}  // namespace mrroc::sim::ur
