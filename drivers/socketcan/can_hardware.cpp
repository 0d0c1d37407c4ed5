#include "drivers/socketcan/can_hardware.hpp"

#include <algorithm>
#include <cmath>

#include "edp/safety/stop_category.hpp"

namespace mrroc::edp {

using namespace canopen;
using can::BusError;

CanHardware::CanHardware(config::DriveTable table, const RobotParameters& robot, double period, OpenBus open_bus,
                         Timing timing, bool synchronised, const config::IoTable& io)
    : table_(std::move(table)),
      period_(period),
      open_bus_(std::move(open_bus)),
      timing_(timing),
      synchronised_(synchronised),
      io_(io, table_, period) {
  if (table_.absolute_encoders && synchronised)
    for (config::DriveEntry& entry : table_.drives) entry.homing.method = 0;  // homing is not used
  for (std::size_t i = 0; i < robot.axes.size(); ++i)
    drives_.emplace_back(table_, table_.drives[i], period, robot.axes[i].motor_synchro);
  heartbeat_ticks_ = std::max<Tick>(1, static_cast<Tick>(table_.heartbeat / period));
  position_ = velocity_ = JointVector::Zero(static_cast<Eigen::Index>(drives_.size()));
}

/// Stops the drives before our heartbeat fails. A command that drives apply at the next SYNC needs a SYNC. Outputs take
/// their error values (CiA 401).
CanHardware::~CanHardware() {
  if (bus_ == nullptr) return;
  for (Drive& drive : drives_) {
    drive.enable(false, tick_);
    send(drive.command({0, drive.position(), 0}));
  }
  send(sync_frame(table_.sync));
  for (Drive& drive : drives_) send(nmt_frame(NmtCommand::enter_pre_operational, drive.node()));
  for (IoNode& node : io_.all()) send(nmt_frame(NmtCommand::stop, node.node()));
}

void CanHardware::read(Tick tick, HardwareInput& input) noexcept {
  synchronise(tick);
  const auto count = static_cast<Eigen::Index>(drives_.size());
  input.motors.resize(count);
  input.current.resize(count);
  input.fault = ErrorCode::none;
  input.time = static_cast<double>(measured_);
  if (timing_.real) input.late = late_;
  if (bus_error_ != BusError::none) {
    input.fault = can::stops_the_bus(bus_error_) ? ErrorCode::bus_off : ErrorCode::bus_error;
    input.fault_detail = DriverText(can::describe(bus_error_));
  }
  read_drives(tick, input);
  // an error of the bus explains it
  if (nodes_lost_ && (input.fault == ErrorCode::hardware_silent || graver(ErrorCode::hardware_silent, input.fault))) {
    input.fault = ErrorCode::hardware_silent;
    input.fault_axis = -1;
    input.fault_detail =
        driver_text("the simulated drives have not answered within %g s of wall time", timing_.timeout);
  }
  io_.read(tick, input);
  input.synchronised = synchronised_;
  input.homing = Homing::none;
  if (homing_ < 0) return;
  const Drive& drive = drives_[static_cast<std::size_t>(homing_)];
  input.homing = drive.homing();
  input.homing_shift = drive.homing_shift();
}

void CanHardware::read_drives(Tick tick, HardwareInput& input) noexcept {
  std::size_t silent = 0;
  for (Eigen::Index i = 0; i < input.motors.size(); ++i) {
    const Drive& drive = drives_[static_cast<std::size_t>(i)];
    input.motors[i] = drive.position();
    input.current[i] = drive.current();
    input.switches[static_cast<std::size_t>(i)] = drive.switches();
    if (!drive.knows_position() && !table_.absolute_encoders) synchronised_ = false;
    const DriveFault fault = drive.fault(tick);
    const auto* silence = std::get_if<Silent>(&fault);
    if (silence != nullptr && silence->how == Silent::How::no_answer) ++silent;
    if (!graver(code_of(fault), input.fault) || is_of_another_axis(drive)) continue;
    input.fault = code_of(fault);
    input.fault_axis = static_cast<int>(i);
    input.fault_detail = describe(fault);
  }
  // with a single drive, a drive failure and a bus failure cannot be distinguished
  if (drives_.size() > 1 && silent == drives_.size() && input.fault == ErrorCode::hardware_silent) {
    input.fault_axis = -1;
    input.fault_detail = driver_text(
        "no drive has answered more than %d SYNCs in a row: they are lost, or the bus is cut", table_.missed_max);
  }
}

/// All axes of a node do.
bool CanHardware::serves(NodeId node) const noexcept {
  return std::all_of(drives_.begin(), drives_.end(),
                     [node](const Drive& drive) { return drive.node() != node || drive.serves(); });
}

/// The EMCY that the node has sent, when another axis of it is in a fault.
bool CanHardware::is_of_another_axis(const Drive& drive) const noexcept {
  if (drive.has_error() || !std::holds_alternative<DriveError>(drive.fault(tick_))) return false;
  return std::any_of(drives_.begin(), drives_.end(),
                     [&drive](const Drive& other) { return other.node() == drive.node() && other.has_error(); });
}

void CanHardware::enable(bool on) noexcept {
  homing_ = -1;
  powering_ = on;
  for (Drive& drive : drives_) drive.enable(on, tick_);
}

void CanHardware::reset_fault() noexcept {
  homing_ = -1;
  powering_ = false;
  bus_error_ = bus_off_ ? BusError::bus_off : BusError::none;
  nodes_lost_ = false;
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    can::Frame next;
    // the servo expects drives without power at the last position that it accepted
    drives_[i].reset(tick_, position_[static_cast<Eigen::Index>(i)], !serves(drives_[i].node()), next);
    if (next.size != 0) begin_set_up(drives_[i].node(), next);
  }
  io_.clear();
  for (IoNode& node : io_.all()) {
    can::Frame next;
    node.reset(tick_, next);
    if (next.size != 0) begin_set_up(node.node(), next);
  }
}

bool CanHardware::busy() const noexcept {
  return std::any_of(drives_.begin(), drives_.end(), [this](const Drive& drive) { return drive.busy(tick_); }) ||
         std::any_of(io_.all().begin(), io_.all().end(), [this](const IoNode& node) { return node.busy(tick_); });
}

void CanHardware::set_points(const JointVector& position, const JointVector& velocity) noexcept {
  position_ = position;
  velocity_ = velocity;
}

/// Drives take different times to switch on: no drive releases its axis before all can, and those that are on first
/// hold their axes until the servo has all of them.
void CanHardware::write(Tick tick, const JointVector& current) noexcept {
  for (IoNode& node : io_.all())
    for (int number = 1; number <= IoPdos::kCount; ++number) send(node.command(number, io_.outputs(), tick));
  const auto is_on = [](const Drive& drive) { return drive.is_on(); };
  const bool all = std::all_of(drives_.begin(), drives_.end(), [](const Drive& drive) { return drive.may_operate(); });
  powering_ = powering_ && !std::all_of(drives_.begin(), drives_.end(), is_on);
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (powering_)
      send(drives_[i].hold(all));
    else
      send(drives_[i].command({current[k], position_[k], velocity_[k]}));
  }
  // the world continues when this tick is over: by then the drives have set their currents
  if (timing_.fenced) pass_fence(true);
}

void CanHardware::set_origin(const JointVector& shift) noexcept {
  homing_ = -1;
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    drives_[i].add_origin(shift[static_cast<Eigen::Index>(i)]);
    drives_[i].position_known();
  }
  position_ += shift;
  synchronised_ = true;
}

void CanHardware::home(int axis) noexcept {
  homing_ = axis;
  drives_[static_cast<std::size_t>(axis)].home();
}

}  // namespace mrroc::edp
