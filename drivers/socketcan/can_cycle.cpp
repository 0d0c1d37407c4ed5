// One cycle of the bus: the SYNC, its answers, and what else its only thread sends and receives.
#include <algorithm>
#include <cmath>

#include "clock/wall/monotonic.hpp"
#include "drivers/socketcan/can_hardware.hpp"

namespace mrroc::edp {

namespace {

using namespace canopen;
using can::BusError;

constexpr double kBetweenStops = 0.1;  // s
constexpr int kLateFrames = 10000;     // at most, taken after a deadline: a babbling node must not stop the servo

std::int64_t ns(double seconds) { return std::llround(seconds * 1e9); }

}  // namespace

/// False: the frame is not on the bus, which is a bus error.
bool CanHardware::send(const can::Frame& frame) noexcept {
  if (frame.id == 0 && frame.size == 0) return true;
  const can::Sent sent = bus_->send(frame);
  if (sent == can::Sent::full) find(BusError::queue_full);
  if (sent == can::Sent::down) find(BusError::down);
  return sent == can::Sent::yes;
}

/// CiA 301: PDOs are mapped in pre-operational, and a node may have started itself (1F80h).
void CanHardware::begin_set_up(NodeId node, const can::Frame& first) noexcept {
  send(nmt_frame(NmtCommand::enter_pre_operational, node));
  send(first);
}

/// The first one, until it is reset; whether the bus still carries frames matters more.
void CanHardware::find(BusError error) noexcept {
  if (bus_error_ == BusError::none || (can::stops_the_bus(error) && !can::stops_the_bus(bus_error_)))
    bus_error_ = error;
}

void CanHardware::take_error(const can::Frame& frame) noexcept {
  const BusError error = can::bus_error_of(frame);
  // the kernel reports only once that the controller is off
  if (error == BusError::bus_off || error == BusError::recovered) bus_off_ = error == BusError::bus_off;
  const bool grave = error == BusError::bus_off || error == BusError::passive || error == BusError::overflow ||
                     error == BusError::no_acknowledge || error == BusError::transceiver;
  if (grave) find(error);
}

/// SocketCAN does not return our own frames, so such a frame comes from another master. Masters of other robots on the
/// same bus have their own nodes, SYNC and heartbeat, and command their own nodes only.
bool CanHardware::is_of_a_master(const can::Frame& frame) const noexcept {
  if (frame.remote || frame.fd) return false;
  if (frame.id == kNmt) return commands_our_nodes(frame);
  return frame.id == table_.sync || frame.id == kHeartbeat + table_.master ||
         std::any_of(drives_.begin(), drives_.end(),
                     [&frame](const Drive& drive) { return frame.id == kReceivePdo1 + drive.pdo_node(); }) ||
         std::any_of(io_.all().begin(), io_.all().end(),
                     [&frame](const IoNode& node) { return node.is_command(frame); });
}

/// Whether an NMT command is to one of the robot's nodes, to all nodes, or malformed.
bool CanHardware::commands_our_nodes(const can::Frame& frame) const noexcept {
  if (frame.size != 2 || frame.data[1] == 0) return true;
  const auto meant = [&frame](const auto& node) { return node.node() == frame.data[1]; };
  return std::any_of(drives_.begin(), drives_.end(), meant) || std::any_of(io_.all().begin(), io_.all().end(), meant);
}

void CanHardware::dispatch(const can::Frame& frame) noexcept {
  if (frame.error) return take_error(frame);
  if (can::fence_of(frame, can::kReturnedFence) == fence_) {
    fence_is_back_ = true;
    return;
  }
  bus_off_ = false;
  if (is_of_a_master(frame)) {
    foreign_sync_ = foreign_sync_ || frame.id == table_.sync;  // answers may be to that SYNC
    return find(BusError::foreign_master);
  }
  bool taken = false;  // by each axis of a node
  for (Drive& drive : drives_) taken = pass(frame, drive) || taken;
  if (taken) return;
  for (IoNode& node : io_.all())
    if (pass(frame, node)) return;
}

/// Passes a frame to a node and sends the node what follows from it. False: the frame is not from this node.
template <class Node>
bool CanHardware::pass(const can::Frame& frame, Node& node) noexcept {
  can::Frame next;
  if (!node.take(frame, tick_, next)) return false;
  const bool has_booted = frame.id == kHeartbeat + node.node() && next.size != 0;
  if (has_booted) {
    begin_set_up(node.node(), next);
    return true;
  }
  send(next);
  if (next != nmt_frame(NmtCommand::start, node.node())) return true;
  // it monitors our heartbeat from the first one on: it must not have power before
  send_heartbeat();
  begin_other_axes(node);
  return true;
}

/// The node of `leader` has been set up and started again.
void CanHardware::begin_other_axes(const Drive& leader) noexcept {
  for (Drive& drive : drives_) {
    if (drive.node() != leader.node() || drive.leads()) continue;
    if (!leader.knows_position()) drive.lose_position();
    drive.begin(tick_);
  }
}

/// A node takes one SDO request at a time.
bool CanHardware::line_is_free(const Drive& drive) const noexcept {
  return std::none_of(drives_.begin(), drives_.end(), [this, &drive](const Drive& other) {
    return other.node() == drive.node() && other.channel() != drive.channel() && other.awaits_mode(tick_);
  });
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

/// Takes the answers to the SYNC that has been sent.
void CanHardware::await_answers(std::int64_t deadline) noexcept {
  if (timing_.fenced)
    pass_fence(false);
  else
    await_all(deadline);
}

/// Takes all frames that follow from those sent so far. False: the nodes have been lost.
bool CanHardware::pass_fence(bool ends_cycle) noexcept {
  fence_ = {table_.master, ends_cycle, fence_.number + 1};
  fence_is_back_ = false;
  if (!send(can::to_frame(fence_, can::kFence))) nodes_lost_ = true;
  const std::int64_t deadline = nodes_lost_ ? 0 : clock::monotonic_ns() + ns(timing_.timeout);
  can::Frame frame;
  // a frame that has arrived is taken also after the deadline: this process may have been stopped meanwhile
  for (int late = 0; late < kLateFrames && bus_->receive(frame, deadline);) {
    dispatch(frame);
    if (fence_is_back_) return true;
    if (clock::monotonic_ns() > deadline) ++late;
  }
  nodes_lost_ = true;
  return false;
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
  const std::int64_t timeout = ns(timing_.timeout);
  const std::int64_t end_of_mail = clock::monotonic_ns() + timeout;
  can::Frame frame;
  // frames received since the last cycle
  while (clock::monotonic_ns() < end_of_mail && bus_->receive(frame, 0)) dispatch(frame);
  if (tick >= next_heartbeat_) {
    send_heartbeat();
    next_heartbeat_ = tick + heartbeat_ticks_;
  }
  send_stops(tick);
  for (Drive& drive : drives_) drive.expect();
  for (IoNode& node : io_.all()) node.expect();
  const std::int64_t tick_begin = static_cast<std::int64_t>(tick) * ns(period_);
  origin_ = std::min(origin_, clock::monotonic_ns() - tick_begin);
  send(sync_frame(table_.sync));
  await_answers(clock::monotonic_ns() + timeout);
  late_ = static_cast<double>(clock::monotonic_ns() - origin_ - tick_begin) / (period_ * 1e9);
  for (Drive& drive : drives_) drive.close_cycle();
  const bool answered =
      std::all_of(drives_.begin(), drives_.end(), [](const Drive& drive) { return drive.answered(); });
  // after a SYNC without an answer the next answer may be a late one to that SYNC
  if (answered && answered_ && !foreign_sync_) measured_ = tick;
  answered_ = answered;
  foreign_sync_ = false;
  for (Drive& drive : drives_) {
    if (drive.repeats(tick, frame)) begin_set_up(drive.node(), frame);
    if (line_is_free(drive) && drive.asks(tick, frame)) send(frame);
  }
  for (IoNode& node : io_.all())
    if (node.repeats(tick, frame)) begin_set_up(node.node(), frame);
}

}  // namespace mrroc::edp
