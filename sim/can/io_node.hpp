#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "can/frame.hpp"
#include "config/drives/io_table.hpp"
#include "mrroc/signals.hpp"
#include "sim/can/node_pdo.hpp"
#include "sim/can/object_store.hpp"
#include "sim/can/sdo_server.hpp"

namespace mrroc::sim {

/// A simulated CiA 401 node on a CAN bus: NMT, SDO, PDOs as they are configured, heartbeats both ways, EMCY, digital
/// and analogue inputs and outputs. When it fails, is stopped, or loses the heartbeat of its master, its outputs take
/// their error values (6206h, 6207h, 6443h, 6444h). It is independent of bus and world: its owner passes frames and
/// inputs to it, takes its outputs, and gives the time, ns. One thread.
class IoNode {
 public:
  using Send = std::function<void(const can::Frame&)>;

  /// `entry` is that of its master's table.
  IoNode(const config::IoEntry& entry, Send send);

  /// Power-on: boot-up message, all values as the manufacturer has set them, outputs off.
  void boot(std::int64_t now);
  /// Takes any frame of the bus except SYNC.
  void take(const can::Frame& frame, std::int64_t now);
  /// Sends what is due by time alone, heartbeats, and watches those of its master.
  void update(std::int64_t now);

  // one cycle
  /// The states of its input terminals, from now on.
  void measure(const ControllerIo& inputs);
  /// Takes a SYNC: sends the inputs that are due.
  void synchronise();
  /// Writes the states of its output terminals.
  void drive(ControllerIo& outputs) const;

  bool operational() const noexcept { return nmt_ == canopen::NmtState::operational; }
  canopen::NodeId node() const noexcept { return entry_.node; }

  // faults to inject
  /// It sends and receives nothing, as with a cut wire.
  void cut(bool on) noexcept { cut_ = on; }
  /// It sends no heartbeats.
  void hush(bool on) noexcept { hushed_ = on; }
  /// Its frames with inputs lack their last byte.
  void shorten(bool on) noexcept { shortens_ = on; }
  /// An error of the device: EMCY, error values; 0: the error has ended.
  void fail(std::uint16_t code);

 private:
  void send(const can::Frame& frame);
  void restart(std::int64_t now);
  void nmt(canopen::NmtCommand command, std::int64_t now);
  void lose_master();
  void use_error_values();
  void send_emergency(std::uint16_t code);

  config::IoEntry entry_;
  Send send_;
  std::unique_ptr<ObjectStore> store_;  ///< in its place while the node moves, for `sdo_`
  SdoServer sdo_;
  canopen::NmtState nmt_ = canopen::NmtState::boot_up;
  std::vector<NodePdo> receive_, transmit_;
  int syncs_ = 0;
  std::int64_t sent_ = 0, heard_ = 0;  ///< heartbeats, ns; 0: none received yet
  bool alone_ = false;                 ///< its master's heartbeat is lost
  bool cut_ = false, hushed_ = false, shortens_ = false;
};

}  // namespace mrroc::sim
