#include "drivers/socketcan/can_hardware.hpp"

#include <algorithm>
#include <cmath>

#include "clock/wall/monotonic.hpp"
#include "edp/safety/stop_category.hpp"

namespace mrroc::edp {

namespace {

using namespace canopen;
using can::BusError;

constexpr double kBetweenStops = 0.1;  // s

std::int64_t ns(double seconds) { return std::llround(seconds * 1e9); }

/// After these errors the bus passes no frames in either direction.
bool stops_the_bus(BusError error) noexcept { return error == BusError::bus_off || error == BusError::down; }

}  // namespace

CanHardware::CanHardware(config::DriveTable table, const RobotParameters& robot, double period, OpenBus open_bus,
                         Timing timing, bool synchronised)
    : table_(std::move(table)),
      period_(period),
      open_bus_(std::move(open_bus)),
      timing_(timing),
      synchronised_(synchronised) {
  if (table_.absolute_encoders && synchronised)
    for (config::DriveEntry& entry : table_.drives) entry.homing.method = 0;  // homing is not used
  for (std::size_t i = 0; i < robot.axes.size(); ++i)
    drives_.emplace_back(table_, table_.drives[i], period, robot.axes[i].motor_synchro);
  heartbeat_ticks_ = std::max<Tick>(1, static_cast<Tick>(table_.heartbeat / period));
  position_ = velocity_ = JointVector::Zero(static_cast<Eigen::Index>(drives_.size()));
}

/// Stops the drives before our heartbeat fails. A command that drives apply at the next SYNC needs a SYNC.
CanHardware::~CanHardware() {
  if (bus_ == nullptr) return;
  for (Drive& drive : drives_) {
    drive.enable(false, tick_);
    send(drive.command({0, drive.position(), 0}));
  }
  send(sync_frame());
  for (Drive& drive : drives_) send(nmt_frame(NmtCommand::enter_pre_operational, drive.node()));
}

void CanHardware::send(const can::Frame& frame) noexcept {
  if (frame.id == 0 && frame.size == 0) return;
  switch (bus_->send(frame)) {
    case can::Sent::yes:
      return;
    case can::Sent::full:
      return find(BusError::queue_full);
    case can::Sent::down:
      return find(BusError::down);
  }
}

/// CiA 301: PDOs are mapped in pre-operational, and a drive may have started itself (1F80h).
void CanHardware::begin_set_up(const Drive& drive, const can::Frame& first) noexcept {
  send(nmt_frame(NmtCommand::enter_pre_operational, drive.node()));
  send(first);
}

/// The first one, until it is reset; whether the bus still carries frames matters more.
void CanHardware::find(BusError error) noexcept {
  if (bus_error_ == BusError::none || (stops_the_bus(error) && !stops_the_bus(bus_error_))) bus_error_ = error;
}

void CanHardware::take_error(const can::Frame& frame) noexcept {
  const BusError error = can::bus_error_of(frame);
  // the kernel reports only once that the controller is off
  if (error == BusError::bus_off || error == BusError::recovered) bus_off_ = error == BusError::bus_off;
  const bool grave = error == BusError::bus_off || error == BusError::passive || error == BusError::overflow ||
                     error == BusError::no_acknowledge || error == BusError::transceiver;
  if (grave) find(error);
}

/// SocketCAN does not return our own frames, so such a frame comes from another master.
bool CanHardware::is_of_a_master(const can::Frame& frame) const noexcept {
  if (frame.remote || frame.fd) return false;
  return frame.id == kNmt || frame.id == kSync || frame.id == kHeartbeat + table_.master ||
         std::any_of(drives_.begin(), drives_.end(),
                     [&frame](const Drive& drive) { return frame.id == kReceivePdo1 + drive.node(); });
}

void CanHardware::dispatch(const can::Frame& frame) noexcept {
  if (frame.error) return take_error(frame);
  bus_off_ = false;
  if (is_of_a_master(frame)) {
    foreign_sync_ = foreign_sync_ || frame.id == kSync;  // answers may be to that SYNC
    return find(BusError::foreign_master);
  }
  can::Frame next;
  for (Drive& drive : drives_) {
    if (!drive.take(frame, tick_, next)) continue;
    const bool has_booted = frame.id == kHeartbeat + drive.node() && next.size != 0;
    if (has_booted) return begin_set_up(drive, next);
    send(next);
    // it monitors our heartbeat from the first one on: it must not have power before
    if (next == nmt_frame(NmtCommand::start, drive.node())) send_heartbeat();
    return;
  }
}

/// Takes frames until every expected drive has answered. False: the timeout came first.
bool CanHardware::await_all(std::int64_t deadline) noexcept {
  const auto waited_for = [](const Drive& drive) { return drive.awaited(); };
  can::Frame frame;
  while (std::any_of(drives_.begin(), drives_.end(), waited_for)) {
    // a babbling node must not delay the tick; received frames are not lost
    if (clock::monotonic_ns() > deadline || !bus_->receive(frame, deadline)) return false;
    dispatch(frame);
  }
  return true;
}

void CanHardware::send_heartbeat() noexcept { send(heartbeat_frame(table_.master, NmtState::operational)); }

/// A drive that has lost its set-points may still receive this: its 6007h defines its reaction.
void CanHardware::send_stops(Tick tick) noexcept {
  if (tick < next_stop_) return;
  for (const Drive& drive : drives_) {
    if (!drive.ignores_controlword()) continue;
    send(nmt_frame(NmtCommand::stop, drive.node()));
    next_stop_ = tick + static_cast<Tick>(std::ceil(kBetweenStops / period_));
  }
}

/// One cycle's SYNC and its answers. SDO requests come after them, because they would delay the SYNC.
void CanHardware::synchronise(Tick tick) noexcept {
  tick_ = tick;
  const std::int64_t patience = ns(timing_.patience);
  const std::int64_t end_of_mail = clock::monotonic_ns() + patience;
  can::Frame frame;
  // frames received since the last cycle
  while (clock::monotonic_ns() < end_of_mail && bus_->receive(frame, 0)) dispatch(frame);
  if (tick >= next_heartbeat_) {
    send_heartbeat();
    next_heartbeat_ = tick + heartbeat_ticks_;
  }
  send_stops(tick);
  for (Drive& drive : drives_) drive.expect();
  const std::int64_t tick_begin = static_cast<std::int64_t>(tick) * ns(period_);
  origin_ = std::min(origin_, clock::monotonic_ns() - tick_begin);
  send(sync_frame());
  await_all(clock::monotonic_ns() + patience);
  late_ = static_cast<double>(clock::monotonic_ns() - origin_ - tick_begin) / (period_ * 1e9);
  for (Drive& drive : drives_) drive.close_cycle();
  const bool answered =
      std::all_of(drives_.begin(), drives_.end(), [](const Drive& drive) { return drive.answered(); });
  // after a SYNC without an answer the next answer may be a late one to that SYNC
  if (answered && answered_ && !foreign_sync_) measured_ = tick;
  answered_ = answered;
  foreign_sync_ = false;
  for (Drive& drive : drives_) {
    if (drive.repeats(tick, frame)) begin_set_up(drive, frame);
    if (drive.asks(tick, frame)) send(frame);
  }
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
    input.fault = stops_the_bus(bus_error_) ? ErrorCode::bus_off : ErrorCode::bus_error;
    input.fault_detail = DriverText(can::describe(bus_error_));
  }
  std::size_t silent = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Drive& drive = drives_[static_cast<std::size_t>(i)];
    input.motors[i] = drive.position();
    input.current[i] = drive.current();
    input.switches[static_cast<std::size_t>(i)] = drive.switches();
    if (!drive.knows_position() && !table_.absolute_encoders) synchronised_ = false;
    const DriveFault fault = drive.fault(tick);
    const auto* silence = std::get_if<Silent>(&fault);
    if (silence != nullptr && silence->how == Silent::How::no_answer) ++silent;
    if (!graver(code_of(fault), input.fault)) continue;
    input.fault = code_of(fault);
    input.fault_axis = static_cast<int>(i);
    input.fault_detail = describe(fault);
  }
  // with a single drive, a drive failure and a bus failure cannot be distinguished
  if (count > 1 && silent == drives_.size() && input.fault == ErrorCode::hardware_silent) {
    input.fault_axis = -1;
    input.fault_detail = driver_text(
        "no drive has answered more than %d SYNCs in a row: they are lost, or the bus is cut", table_.missed_max);
  }
  input.synchronised = synchronised_;
  input.homing = Homing::none;
  if (homing_ < 0) return;
  const Drive& drive = drives_[static_cast<std::size_t>(homing_)];
  input.homing = drive.homing();
  input.homing_shift = drive.homing_shift();
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
  for (std::size_t i = 0; i < drives_.size(); ++i) {
    can::Frame next;
    // the servo expects drives without power at the last position that it accepted
    drives_[i].reset(tick_, position_[static_cast<Eigen::Index>(i)], next);
    if (next.size != 0) begin_set_up(drives_[i], next);
  }
}

bool CanHardware::busy() const noexcept {
  return std::any_of(drives_.begin(), drives_.end(), [this](const Drive& drive) { return drive.busy(tick_); });
}

void CanHardware::set_points(const JointVector& position, const JointVector& velocity) noexcept {
  position_ = position;
  velocity_ = velocity;
}

/// Drives take different times to switch on: no drive releases its axis before all can, and those that are on first
/// hold their axes until the servo has all of them.
void CanHardware::write(Tick, const JointVector& current) noexcept {
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
