// Faults of a bus or a drive.
#pragma once

#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "bus_fault_rig.hpp"

namespace mrroc::edp {

/// One kind of fault.
struct Case {
  std::string name;
  std::vector<ErrorCode> codes;  ///< permitted codes of the error
  std::string text;              ///< text of the error
  std::function<void(Rig&)> begin;
  std::function<void(Rig&)> end;
  bool on_sockets = true;  ///< also on the kernel's sockets
  bool hears = true;       ///< drives still receive a frame that stops them
  bool obeys = true;       ///< motors follow the EDP's commands, and encoders are correct
};

inline void with_node(Rig& rig, const std::function<void(sim::DriveNode&)>& action) {
  rig.rack.with([&](auto& nodes) { action(rig.node(nodes)); });
}

/// Injects a report of the controller as a frame from outside.
inline void report(Rig& rig, std::uint32_t classes, std::uint8_t controller) {
  can::Frame frame{classes, {0, controller, 0, 0, 0, 0, 0, 0}};
  frame.error = true;
  rig.bus.open()->send(frame);
}

inline void nothing(Rig&) {}

/// From now on another node sends `count` frames in every tick, with random data and the identifiers of `identifier`.
inline void babble(Rig& rig, int count, const std::function<std::uint32_t(std::mt19937&)>& identifier) {
  rig.before_tick = [&rig, count, identifier, babbler = std::shared_ptr<can::Bus>(rig.bus.open())] {
    for (int i = 0; i < count; ++i) {
      can::Frame frame;
      frame.id = identifier(rig.random);
      frame.size = static_cast<std::uint8_t>(rig.random() % 9);
      for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(rig.random());
      babbler->send(frame);
    }
  };
}

/// In every tick another node sends frames that only the master may send.
inline void command(Rig& rig, const std::function<can::Frame(Rig&)>& frame) {
  rig.before_tick = [&rig, frame, unknown = std::shared_ptr<can::Bus>(rig.bus.open())] { unknown->send(frame(rig)); };
}

/// A set-point that keeps the axis at its position.
inline can::Frame foreign_set_point(Rig& rig) {
  can::Frame frame{0x203, {canopen::kEnableOperation, 0, 0, 0, 0, 0, 8}};
  const double units = rig.rack.shafts()[kAxis] / (2 * std::numbers::pi) * 4000;
  can::put(frame.data, 2, 4, static_cast<std::uint64_t>(std::llround(units)));
  return frame;
}

/// `frame` from another master.
inline Case foreign(const std::string& name, const std::function<can::Frame(Rig&)>& frame) {
  return {"Foreign" + name,
          {ErrorCode::bus_error},
          "another node sends SYNC, NMT or set-points",
          [frame](Rig& rig) { command(rig, frame); },
          [](Rig& rig) { rig.before_tick = {}; },
          true,
          true,
          false};
}

inline std::vector<Case> cases() {
  return {
      {"NodeLost",
       {ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.cut(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.cut(false); }); }},
      {"HeartbeatLost",
       {ErrorCode::heartbeat_lost},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.hush(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.hush(false); }); }},
      {"SwitchesLost",
       {ErrorCode::hardware_silent},
       "axis 3 (z), tick ",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.withhold_status(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.withhold_status(false); }); }},
      {"LimitSwitch",
       {ErrorCode::limit_switch},
       "axis 3 (z), tick ",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.press(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.press(false); }); }},
      {"Emergency",
       {ErrorCode::drive_fault},
       "error code 7305h, incremental sensor 1 fault",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.fail(0x7305); }); },
       nothing},
      {"Restarted",
       {ErrorCode::drive_restarted, ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.boot(0); }); },
       nothing},
      {"BusOff", {ErrorCode::bus_off}, "bus off", [](Rig& rig) { report(rig, 0x40, 0); }, nothing},
      {"ErrorPassive", {ErrorCode::bus_error}, "error passive", [](Rig& rig) { report(rig, 0x4, 0x20); }, nothing},
      {"Overflow",
       {ErrorCode::bus_error},
       "overflow: the controller has lost frames",
       [](Rig& rig) { report(rig, 0x4, 0x1); },
       nothing},
      {"NobodyAcknowledges", {ErrorCode::bus_error}, "no acknowledge", [](Rig& rig) { report(rig, 0x20, 0); }, nothing},
      {"Transceiver", {ErrorCode::bus_error}, "transceiver", [](Rig& rig) { report(rig, 0x10, 0); }, nothing},
      {"QueueFull",
       {ErrorCode::bus_error},
       "transmit queue full",
       [](Rig& rig) {
         if (rig.bus.is_hub())
           rig.weak_bus->answer = can::Sent::full;
         else
           disturb(rig, "limit 1 delay 10s");
       },
       [](Rig& rig) {
         rig.weak_bus->answer = can::Sent::yes;
         if (!rig.bus.is_hub()) leave_in_peace(rig);
       },
       true,
       false},
      {"InterfaceDown",
       {ErrorCode::bus_off},
       "the interface is down",
       [](Rig& rig) {
         if (rig.bus.is_hub())
           rig.weak_bus->answer = can::Sent::down;
         else
           interface(rig, "ip link set DEV down");
       },
       [](Rig& rig) {
         rig.weak_bus->answer = can::Sent::yes;
         if (!rig.bus.is_hub()) interface(rig, "ip link set DEV up");
       },
       true,
       false},
      {"SyncLost",
       {ErrorCode::hardware_silent},
       "no drive has answered more than 2 SYNCs in a row: they are lost, or the bus is cut",
       [](Rig& rig) { rig.weak_bus->loses_syncs = true; },
       [](Rig& rig) { rig.weak_bus->loses_syncs = false; }},
      {"PositionStuck",
       {ErrorCode::axis_stuck, ErrorCode::following_error, ErrorCode::overspeed, ErrorCode::encoder_fault},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.freeze(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.freeze(false); }); },
       true,
       true,
       false},
      {"Impostor",
       {ErrorCode::encoder_fault},
       "answers more than SYNCs: another node sends under its number",
       [](Rig& rig) { babble(rig, 5, [](std::mt19937&) { return 0x183u; }); },
       [](Rig& rig) { rig.before_tick = {}; },
       true,
       true,
       false},
      {"BitsTurnedOver",
       {ErrorCode::encoder_fault, ErrorCode::drive_fault, ErrorCode::drive_not_ready, ErrorCode::overspeed,
        ErrorCode::following_error, ErrorCode::axis_stuck},
       "axis 3 (z)",
       [](Rig& rig) {
         rig.spoil.use([&rig](can::Frame& frame) {
           if (frame.id == 0x183) frame.data[rig.random() % 6] ^= static_cast<std::uint8_t>(1 + rig.random() % 255);
           return true;
         });
       },
       [](Rig& rig) { rig.spoil.use({}); },
       false,
       true,
       false},
      {"FollowingError",
       {ErrorCode::following_error},
       "reported by its drive",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.stray(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.stray(false); }); }},
      {"ModeLost",
       {ErrorCode::axis_stuck, ErrorCode::following_error},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.stay_in(canopen::DriveMode{1}); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.stay_in({}); }); }},
      {"SetPointsLost",
       {ErrorCode::axis_stuck, ErrorCode::following_error},
       "axis 3 (z)",
       [](Rig& rig) { rig.spoil.use([](can::Frame& frame) { return frame.id != 0x203; }); },
       [](Rig& rig) { rig.spoil.use({}); },
       false},
      {"FramesLost",
       {ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { rig.spoil.use([](can::Frame& frame) { return frame.id != 0x183; }); },
       [](Rig& rig) { rig.spoil.use({}); },
       false},
      foreign("Sync", [](Rig&) { return canopen::sync_frame(); }),
      foreign("Nmt", [](Rig&) { return canopen::nmt_frame(canopen::NmtCommand::start, 3); }),
      foreign("Heartbeat", [](Rig&) { return canopen::heartbeat_frame(127, canopen::NmtState::operational); }),
      foreign("SetPoints", foreign_set_point),
  };
}

}  // namespace mrroc::edp
