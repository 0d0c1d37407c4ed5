#pragma once

#include <cstdint>
#include <string_view>

#include "can/frame.hpp"

namespace mrroc::canopen {

/// A node of a CANopen network, 1..127; 0 addresses all of them.
using NodeId = std::uint8_t;
inline constexpr NodeId kMaxNode = 127;
/// PDOs of a node in each direction, at most (CiA 301).
inline constexpr int kMaxPdos = 512;

/// Identifiers of the predefined connection set (CiA 301, 7.3.5); with a node's number added except for the first
/// three.
inline constexpr std::uint32_t kNmt = 0x000;
inline constexpr std::uint32_t kSync = 0x080;
inline constexpr std::uint32_t kLastSync = 0x0ff;  ///< of those that 1005h may have here: EMCY of node 127
inline constexpr std::uint32_t kTime = 0x100;
inline constexpr std::uint32_t kEmergency = 0x080;
inline constexpr std::uint32_t kTransmitPdo1 = 0x180;  ///< from the drive; number n at + 0x100 (n - 1)
inline constexpr std::uint32_t kReceivePdo1 = 0x200;   ///< to the drive
inline constexpr std::uint32_t kSdoResponse = 0x580;   ///< from the drive
inline constexpr std::uint32_t kSdoRequest = 0x600;    ///< to the drive
inline constexpr std::uint32_t kHeartbeat = 0x700;

/// A command of the master to a node (CiA 301, 7.2.8.3.1).
enum class NmtCommand : std::uint8_t {
  start = 0x01,
  stop = 0x02,
  enter_pre_operational = 0x80,
  reset_node = 0x81,
  reset_communication = 0x82
};

/// A node's state in its heartbeat.
enum class NmtState : std::uint8_t { boot_up = 0x00, stopped = 0x04, operational = 0x05, pre_operational = 0x7f };

inline can::Frame nmt_frame(NmtCommand command, NodeId node) {
  return {kNmt, {static_cast<std::uint8_t>(command), node}};
}
/// `identifier`: of a bus with several producers, kSync to kLastSync.
inline can::Frame sync_frame(std::uint32_t identifier = kSync) { return {identifier, {}}; }
inline can::Frame heartbeat_frame(NodeId node, NmtState state) {
  return {kHeartbeat + node, {static_cast<std::uint8_t>(state)}};
}

/// "pre-operational"; "unknown" for other values.
constexpr std::string_view describe(NmtState state) noexcept {
  switch (state) {
    case NmtState::boot_up:
      return "boot-up";
    case NmtState::stopped:
      return "stopped";
    case NmtState::operational:
      return "operational";
    case NmtState::pre_operational:
      return "pre-operational";
  }
  return "unknown";
}

constexpr std::string_view describe(NmtCommand command) noexcept {
  switch (command) {
    case NmtCommand::start:
      return "start";
    case NmtCommand::stop:
      return "stop";
    case NmtCommand::enter_pre_operational:
      return "enter pre-operational";
    case NmtCommand::reset_node:
      return "reset node";
    case NmtCommand::reset_communication:
      return "reset communication";
  }
  return "unknown";
}

}  // namespace mrroc::canopen
