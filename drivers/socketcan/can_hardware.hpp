#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "can/bus.hpp"
#include "can/bus_error.hpp"
#include "can/fence.hpp"
#include "canopen/sdo_client.hpp"
#include "drivers/socketcan/drive.hpp"
#include "drivers/socketcan/io_nodes.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

/// The drives of a robot on a CAN bus, CiA 402 nodes with one axis or several, and the terminals of its controller, CiA
/// 401 nodes. The servo's thread is the bus's only thread: `read` sends the SYNC and takes the nodes' answers, `write`
/// sends each its command; both also send heartbeats, NMT commands and the set-up of a node that has restarted. A
/// cycle is
///
///   SYNC, TPDO 1 of every drive (and TPDO 2 and the inputs at each `status_every`-th SYNC), changed outputs, RPDO 1 to
///   every drive.
///
/// It waits for TPDO 1 of the drives, not for the inputs, which are the newest ones received.
///
/// The position of a drive that leaves up to `missed_max` SYNCs unanswered is extrapolated; then the drive is silent.
/// An error on the bus or in a drive is a fault of the robot, with the axis and the drive's own code.
///
/// `enable(false)` is a quick stop: drives that still turn slow down on their own ramp before they let go. The drives
/// watch our heartbeat, so they also do this when this process dies. Outputs take their error values then.
class CanHardware : public Hardware {
 public:
  struct Timing {
    double timeout;     ///< timeout for the answers to a SYNC, s of wall time
    bool real = false;  ///< ticks follow the wall clock, and positions measured after their tick are reported as late
    /// Lockstep: the nodes are simulated and return fences, so that the content of a cycle does not depend on wall
    /// time. `timeout` is that for a fence: after it the nodes are lost.
    bool fenced = false;
    double boot_timeout = 10;  ///< s of wall time, for all nodes to boot; not with `fenced`: simulators start meanwhile
  };

  /// Opens the bus; throws HardwareError or std::runtime_error.
  using OpenBus = std::function<std::unique_ptr<can::Bus>()>;
  /// `period` in s. `synchronised`: positions are right from the start. `io`: the I/O nodes on the same bus.
  CanHardware(config::DriveTable table, const RobotParameters& robot, double period, OpenBus open_bus, Timing timing,
              bool synchronised, const config::IoTable& io = {});
  ~CanHardware() override;

  /// Opens the bus, resets the nodes' communication, waits for each to boot, takes the power of a drive that still has
  /// it, clears a fault, sets each node up and starts it, until all answer a SYNC. Throws HardwareError that names
  /// drive, node and problem: no boot-up, not a CiA 402 drive or a CiA 401 node with its terminals, power or a fault
  /// that stays, a rejected setting, no answer.
  void open() override;
  void enable(bool on) noexcept override;
  void reset_fault() noexcept override;
  bool busy() const noexcept override;
  /// In mode torque.
  bool follows_current() const noexcept override { return table_.mode == canopen::DriveMode::cyclic_torque; }
  void read(Tick tick, HardwareInput& input) noexcept override;
  void set_points(const JointVector& position, const JointVector& velocity) noexcept override;
  void write(Tick tick, const JointVector& current) noexcept override;
  void set_outputs(const ControllerIo& outputs) noexcept override { io_.set_outputs(outputs); }
  void set_origin(const JointVector& shift) noexcept override;
  bool homes() const noexcept override { return true; }
  void home(int axis) noexcept override;

  static constexpr double kFenceTimeout = 10;  ///< s of wall time, after which simulated nodes in lockstep are lost

 private:
  // the start; a place is a drive's axis, or the number of axes and the place of an I/O node
  std::size_t places() const noexcept { return drives_.size() + io_.all().size(); }
  bool is_drive(std::size_t place) const noexcept { return place < drives_.size(); }
  IoNode& io_node(std::size_t place) noexcept { return io_.all()[place - drives_.size()]; }
  canopen::NodeId node_at(std::size_t place) const noexcept;
  NodeSetup& setup_at(std::size_t place) noexcept;
  /// Whether the settings of the node are written for this place: once for a drive with several axes.
  bool sets_up(std::size_t place) const noexcept { return !is_drive(place) || drives_[place].leads(); }
  canopen::Object object_of(std::size_t axis, canopen::Object object) const noexcept {
    return canopen::of_channel(object, drives_[axis].channel());
  }
  void await_boot();
  void note(const can::Frame& frame);
  void set_up_all();
  void set_up(std::size_t place);
  void write_settings(std::size_t place);
  void prepare_axes(std::size_t first, canopen::SdoClient& client);
  void prepare_drive(std::size_t axis, canopen::SdoClient& client);
  void check_modes(std::size_t axis, canopen::SdoClient& client) const;
  canopen::DriveState read_state(std::size_t axis, canopen::SdoClient& client);
  void take_power(std::size_t axis, canopen::SdoClient& client);
  void clear_fault(std::size_t axis, canopen::SdoClient& client);
  void prepare_io_node(std::size_t place, canopen::SdoClient& client);
  void await_first_answers();
  bool all_answer() const noexcept;
  void begin_set_up(canopen::NodeId node, const can::Frame& first) noexcept;
  bool send(const can::Frame& frame) noexcept;
  void send_heartbeat() noexcept;
  void send_stops(Tick tick) noexcept;
  void find(can::BusError error) noexcept;
  void take_error(const can::Frame& frame) noexcept;
  bool commands_our_nodes(const can::Frame& frame) const noexcept;
  bool is_of_a_master(const can::Frame& frame) const noexcept;
  void dispatch(const can::Frame& frame) noexcept;
  template <class Node>
  bool pass(const can::Frame& frame, Node& node) noexcept;
  void begin_other_axes(const Drive& leader) noexcept;
  void begin_other_axes(const IoNode&) noexcept {}
  bool serves(canopen::NodeId node) const noexcept;
  bool is_of_another_axis(const Drive& drive) const noexcept;
  bool line_is_free(const Drive& drive) const noexcept;
  bool await_all(std::int64_t deadline) noexcept;
  void await_answers(std::int64_t deadline) noexcept;
  bool pass_fence(bool ends_cycle) noexcept;
  std::int64_t sdo_timeout() const noexcept;
  void synchronise(Tick tick) noexcept;
  void read_drives(Tick tick, HardwareInput& input) noexcept;
  [[noreturn]] void fail(ErrorCode code, std::size_t place, const std::string& what) const;

  config::DriveTable table_;
  double period_;
  OpenBus open_bus_;
  std::unique_ptr<can::Bus> bus_;  ///< null before `open`
  Timing timing_;
  bool synchronised_;
  std::vector<Drive> drives_;
  IoNodes io_;
  std::vector<bool> set_up_;  ///< of each place, during the start: since its last boot-up message
  can::BusError bus_error_ = can::BusError::none;
  bool bus_off_ = false;  ///< the controller has left the bus, and has not come back yet
  Tick tick_ = 0;
  std::int64_t origin_ = INT64_MAX;  ///< wall time of tick 0, ns, estimated from the SYNC with the least delay
  bool answered_ = true;             ///< by all drives, the last SYNC
  bool foreign_sync_ = false;        ///< another master's, in this cycle
  can::Fence fence_;                 ///< the last one sent
  bool fence_is_back_ = false;
  bool nodes_lost_ = false;  ///< a fence did not come back in time: none is awaited until `reset_fault`
  Tick measured_ = 0;        ///< the last tick whose positions are measured and certainly its own
  double late_ = 0;          ///< of this cycle's last answer, servo periods after its tick
  Tick heartbeat_ticks_ = 0;
  Tick next_heartbeat_ = 0;
  Tick next_stop_ = 0;     ///< of drives that ignore their controlword
  bool powering_ = false;  ///< `enable(true)` was called, and not all drives are on yet
  int homing_ = -1;        ///< axis
  JointVector position_, velocity_;
};

}  // namespace mrroc::edp
