#include "drivers/socketcan/io_node.hpp"

#include <algorithm>

#include "canopen/emergency.hpp"
#include "drivers/socketcan/io_setup.hpp"
#include "drivers/socketcan/setting_list.hpp"
#include "drivers/socketcan/ticks_of.hpp"

namespace mrroc::edp {

using namespace canopen;

namespace {

constexpr std::uint32_t kBetweenPdos = 0x100;  // of the identifiers of two PDOs of a node

std::size_t place(int number) noexcept { return static_cast<std::size_t>(number - 1); }

/// Of PDO `number` of a node, when that of PDO 1 is `first`.
std::uint32_t identifier(std::uint32_t first, int number, NodeId node) noexcept {
  return first + kBetweenPdos * static_cast<std::uint32_t>(number - 1) + node;
}

}  // namespace

IoNode::IoNode(const config::IoEntry& entry, const config::DriveTable& drives, double period)
    : node_(entry.node),
      pdos_(entry),
      setup_(entry.node, io_settings(entry, drives)),
      without_max_(drives.status_every * (drives.missed_max + 1)),
      heartbeat_ticks_(ticks_of(kMissedHeartbeats * drives.heartbeat, period)),
      repeat_ticks_(ticks_of(drives.heartbeat, period)),
      answer_ticks_(ticks_of(kAnswerTime, period)),
      set_up_ticks_(ticks_of(drives.switch_on_time, period)) {}

bool IoNode::take(const can::Frame& frame, Tick tick, can::Frame& next) noexcept {
  next = {};
  if (frame.error || frame.remote || frame.fd) return false;
  for (int number = 1; number <= IoPdos::kCount; ++number) {
    if (pdos_.transmit(number).size() == 0 || frame.id != identifier(kTransmitPdo1, number, node_)) continue;
    if (!pdos_.read(frame, number, inputs_)) return true;  // too short: ignored
    without_[place(number)] = 0;
    received_[place(number)] = true;
    return true;
  }
  if (frame.id == kHeartbeat + node_) {
    take_heartbeat(frame, tick, next);
  } else if (const auto emergency = emergency_of(frame); emergency && emergency->node == node_) {
    emergency_ = emergency->code;
    if (emergency_ != 0) error_ = emergency_;
  } else if (frame.id == kSdoResponse + node_) {
    take_response(frame, tick, next);
  } else {
    return false;
  }
  return true;
}

/// A node in service that is not operational has restarted, or another master has stopped it.
void IoNode::take_heartbeat(const can::Frame& frame, Tick tick, can::Frame& next) noexcept {
  heard_ = tick;
  if (frame.size < 1) return;
  const auto state = static_cast<NmtState>(frame.data[0] & 0x7f);
  if (state == NmtState::boot_up) {
    emergency_ = 0;
    if (setup_.status() == NodeSetup::Status::writing) next = setup_.start();
    asked_ = tick;
  }
  const bool stale = state != NmtState::boot_up && tick <= begun_ + heartbeat_ticks_;  // sent before it was started
  if (!in_service_ || state == NmtState::operational || stale) return;
  restarted_ = true;
  in_service_ = false;
}

void IoNode::take_response(const can::Frame& frame, Tick tick, can::Frame& next) noexcept {
  if (!setup_.take(frame, next)) return;
  asked_ = tick;
  if (setup_.status() != NodeSetup::Status::done) return;
  setup_.give_up();
  begin(tick);
  next = nmt_frame(NmtCommand::start, node_);
}

bool IoNode::is_command(const can::Frame& frame) const noexcept {
  for (int number = 1; number <= IoPdos::kCount; ++number)
    if (pdos_.receive(number).size() != 0 && frame.id == identifier(kReceivePdo1, number, node_)) return true;
  return false;
}

void IoNode::expect() noexcept {
  if (!in_service_) return;
  for (int& without : without_) without = std::min(without + 1, without_max_ + 1);
}

bool IoNode::knows_inputs() const noexcept {
  for (int number = 1; number <= IoPdos::kCount; ++number)
    if (pdos_.transmit(number).size() != 0 && !received_[place(number)]) return false;
  return true;
}

int IoNode::missing_pdo() const noexcept {
  for (int number = 1; number <= IoPdos::kCount; ++number)
    if (pdos_.transmit(number).size() != 0 && without_[place(number)] > without_max_) return number;
  return 0;
}

void IoNode::read(Tick tick, ControllerIo& inputs) const noexcept {
  if (!is_lost(tick) && knows_inputs()) pdos_.copy_inputs(inputs_, inputs);
}

IoFault IoNode::fault(Tick tick) const noexcept {
  if (setup_.status() == NodeSetup::Status::refused) return IoSetupRefused{setup_.setting().object, setup_.abort()};
  if (restarted_) return IoRestarted{};
  if (const int number = missing_pdo(); number != 0) return IoSilent{number, without_max_};
  if (is_hushed(tick)) return IoHeartbeatLost{tick - heard_, heartbeat_ticks_};
  if (error_ != 0) return IoError{error_};
  return {};
}

void IoNode::begin(Tick tick) noexcept {
  in_service_ = true;
  restarted_ = false;
  without_.fill(0);
  received_.fill(false);
  due_.fill(tick);
  heard_ = begun_ = tick;
}

void IoNode::reset(Tick tick, can::Frame& next) noexcept {
  next = {};
  error_ = emergency_;
  reset_ = tick;
  if (in_service_ && missing_pdo() == 0) return;
  emergency_ = error_ = 0;
  in_service_ = false;
  next = setup_.start();
  asked_ = tick;
}

bool IoNode::repeats(Tick tick, can::Frame& next) noexcept {
  if (setup_.status() != NodeSetup::Status::writing || tick <= asked_ + answer_ticks_) return false;
  next = setup_.again();
  asked_ = tick;
  return true;
}

bool IoNode::busy(Tick tick) const noexcept {
  const bool done = in_service_ && knows_inputs();
  return !done && tick <= reset_ + set_up_ticks_;
}

can::Frame IoNode::command(int number, const ControllerIo& outputs, Tick tick) noexcept {
  if (!in_service_ || pdos_.receive(number).size() == 0) return {};
  const can::Frame frame = pdos_.write(number, outputs);
  if (frame == sent_[place(number)] && tick < due_[place(number)]) return {};
  due_[place(number)] = tick + repeat_ticks_;
  sent_[place(number)] = frame;
  return frame;
}

}  // namespace mrroc::edp
