#pragma once

#include <array>
#include <cstdint>

#include "drivers/socketcan/io_fault.hpp"
#include "drivers/socketcan/io_pdos.hpp"
#include "drivers/socketcan/node_setup.hpp"
#include "mrroc/signals.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// One CiA 401 node as its master sees it: its inputs, its outputs, its set-up and its faults. It does no I/O of its
/// own: its owner passes the frames in both directions. Time is the servo's tick. Allocates in the constructor only;
/// one thread; never throws.
///
///   out of service -> in service        `begin`: it has been set up and is started
///   in service -> out of service        it boots, or reports that it is not operational; `reset` of a silent node
class IoNode {
 public:
  static constexpr double kAnswerTime = 0.1;  ///< s, to a request of the set-up; then it is sent again

  /// `drives`: the table of drives on the same bus; `period` in s.
  IoNode(const config::IoEntry& entry, const config::DriveTable& drives, double period);

  canopen::NodeId node() const noexcept { return node_; }
  NodeSetup& setup() noexcept { return setup_; }
  const IoPdos& pdos() const noexcept { return pdos_; }

  // ---- received
  /// Takes any frame of the bus; true: it is from this node. `next` is to be sent unless it is empty.
  bool take(const can::Frame& frame, Tick tick, can::Frame& next) noexcept;
  /// The frame has the identifier of a PDO that only the node's master sends.
  bool is_command(const can::Frame& frame) const noexcept;
  /// A SYNC is about to be sent.
  void expect() noexcept;
  /// Every TPDO has been received since the node is in service.
  bool knows_inputs() const noexcept;
  /// Writes its inputs into its terminals, which are off and 0 while the node is lost: restarted, silent, or without a
  /// heartbeat.
  void read(Tick tick, ControllerIo& inputs) const noexcept;
  IoFault fault(Tick tick) const noexcept;

  // ---- commands
  /// The node has been set up and started: from `tick` on it sends its inputs.
  void begin(Tick tick) noexcept;
  /// Clears the faults whose cause is gone. A node that is out of service or silent is set up and started again, with
  /// `next` as the first request.
  void reset(Tick tick, can::Frame& next) noexcept;
  /// True: the set-up is under way and its last request has not been answered within kAnswerTime; `next` is to be sent.
  bool repeats(Tick tick, can::Frame& next) noexcept;
  /// The set-up after the last `reset` is under way, and there is still time.
  bool busy(Tick tick) const noexcept;
  /// RPDO `number` when it has to be sent: an output has changed, or a heartbeat period has passed. Else empty.
  can::Frame command(int number, const ControllerIo& outputs, Tick tick) noexcept;

 private:
  void take_heartbeat(const can::Frame& frame, Tick tick, can::Frame& next) noexcept;
  void take_response(const can::Frame& frame, Tick tick, can::Frame& next) noexcept;
  /// The first TPDO that is missing for too long; 0: none.
  int missing_pdo() const noexcept;
  bool is_lost(Tick tick) const noexcept { return !in_service_ || missing_pdo() != 0 || is_hushed(tick); }
  bool is_hushed(Tick tick) const noexcept { return tick > heard_ + heartbeat_ticks_; }

  canopen::NodeId node_;
  IoPdos pdos_;
  NodeSetup setup_;
  int without_max_;  ///< SYNCs
  Tick heartbeat_ticks_, repeat_ticks_, answer_ticks_, set_up_ticks_;

  ControllerIo inputs_;
  bool in_service_ = false, restarted_ = false;
  std::uint16_t emergency_ = 0;                  ///< its present error
  std::uint16_t error_ = 0;                      ///< the error since the last reset
  std::array<int, IoPdos::kCount> without_{};    ///< SYNCs since each TPDO
  std::array<bool, IoPdos::kCount> received_{};  ///< since it is in service
  std::array<can::Frame, IoPdos::kCount> sent_;  ///< RPDOs
  std::array<Tick, IoPdos::kCount> due_{};       ///< when they are sent at the latest
  Tick heard_ = 0;                               ///< the last heartbeat
  Tick begun_ = 0, reset_ = 0;
  Tick asked_ = 0;  ///< the last request of the set-up
};

}  // namespace mrroc::edp
