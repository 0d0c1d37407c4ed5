#include "sim/can/drive_node.hpp"

#include <cmath>
#include <numbers>

namespace mrroc::sim {

using namespace canopen;

namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

}  // namespace

DriveNode::DriveNode(const config::DriveTable& table, const config::DriveEntry& entry, const AxisParameters& axis,
                     double period, Send send)
    : node_(entry.node),
      channel_(table, entry),
      units_per_rad_(entry.units_per_turn / (2 * std::numbers::pi)),
      velocity_units_per_rad_(entry.velocity_units_per_turn / (2 * std::numbers::pi)),
      rated_current_(entry.rated_current),
      reversed_(entry.units_per_turn < 0),
      absolute_(table.absolute_encoders),
      send_(std::move(send)),
      store_(table.eds.of_axis(entry.channel, entry.first_pdo), entry.node),
      sdo_(entry.node, store_),
      motor_(axis, period) {}

double DriveNode::shaft(std::int64_t units) const noexcept {
  return static_cast<double>(units - raw_offset_) / units_per_rad_;
}

std::int64_t DriveNode::units(double shaft) const noexcept {
  return std::llround(shaft * units_per_rad_) + raw_offset_;
}

void DriveNode::send(can::Frame frame) {
  if (cut_) return;
  if (corrupts_ && frame.size != 0) frame.data[noise_() % frame.size] = static_cast<std::uint8_t>(noise_());
  if (const auto of_node = channel_.sent(frame)) send_(*of_node);
}

void DriveNode::boot(std::int64_t now) {
  if (!absolute_) raw_offset_ -= units(position_);
  store_.reset();
  state_ = DriveState::switch_on_disabled;
  controlword_ = 0;
  mode_ = DriveMode::none;
  homed_ = homing_failed_ = false;
  restart(now);
}

/// CiA 301: objects 1000h to 1FFFh. The motor, its state, its error and the profile's objects stay as they are.
void DriveNode::reset_communication(std::int64_t now) {
  if (powered()) lose_master();
  const std::int64_t error = store_.number(kErrorRegister);
  store_.reset_communication();
  store_.set(kErrorRegister, error);
  restart(now);
}

/// Restarts the communication.
void DriveNode::restart(std::int64_t now) {
  nmt_ = NmtState::pre_operational;
  sdo_.reset();
  store_.lock_mappings(false);
  command_.reset();
  feedback_.reset();
  status_.reset();
  has_pending_ = commanded_ = false;
  heard_ = 0;
  sent_ = now;
  send(heartbeat_frame(node_, NmtState::boot_up));
  if (starts_itself_) nmt(NmtCommand::start, now);
}

void DriveNode::nmt(NmtCommand command, std::int64_t now) {
  switch (command) {
    case NmtCommand::start:
      use_pdos();
      nmt_ = NmtState::operational;
      store_.lock_mappings(true);
      syncs_ = 0;
      return;
    case NmtCommand::stop:
    case NmtCommand::enter_pre_operational:
      nmt_ = command == NmtCommand::stop ? NmtState::stopped : NmtState::pre_operational;
      store_.lock_mappings(false);
      if (powered() && command == NmtCommand::stop) lose_master();
      return;
    case NmtCommand::reset_node:
      return boot(now);
    case NmtCommand::reset_communication:
      return reset_communication(now);
  }
}

void DriveNode::use_pdos() {
  command_ = configured_pdo(store_, kReceivePdoParameters);
  feedback_ = configured_pdo(store_, kTransmitPdoParameters);
  status_ = configured_pdo(store_, kTransmitPdoParameters + 1);
}

void DriveNode::take(const can::Frame& frame, std::int64_t now) {
  if (cut_ || frame.error || frame.remote || frame.fd) return;
  if (frame.id == kNmt && frame.size == 2 && (frame.data[1] == 0 || frame.data[1] == node_)) {
    nmt(static_cast<NmtCommand>(frame.data[0]), now);
  } else if (frame.id == kSdoRequest + node_) {
    const auto own = channel_.received(frame);
    if (own && nmt_ != NmtState::stopped) take_request(*own, now);
  } else if (operational() && command_ && frame.id == command_->identifier) {
    commanded_ = true;
    if (owes_) send(last_feedback_);
    owes_ = false;
    if (!command_->waits_for_sync()) return take_command(frame);
    pending_ = frame;
    has_pending_ = true;
  } else if (const auto watched = static_cast<std::uint32_t>(store_.number(kConsumerHeartbeat));
             watched != 0 && frame.id == kHeartbeat + (watched >> 16 & 0x7f)) {
    heard_ = now;
  }
}

/// Answers with the present statusword; a controlword or mode takes effect from SDOs, too.
void DriveNode::take_request(const can::Frame& frame, std::int64_t now) {
  if (deaf_for_ > 0 && deaf_for_-- > 0) return;
  take_mode();
  follow_state();
  if (const auto answer = sdo_.answer(frame)) send(*answer);
  take_mode();
  if (store_.number(kControlword) != controlword_) obey();
  if (restless_) boot(now);
}

void DriveNode::take_command(const can::Frame& frame) {
  if (command_->take(frame, store_)) obey();
}

void DriveNode::update(std::int64_t now) {
  const std::int64_t produced = store_.number(kProducerHeartbeat) * kMillisecond;
  if (nmt_ != NmtState::boot_up && produced != 0 && now >= sent_ + produced) {
    sent_ = now;
    if (!hushed_) send(heartbeat_frame(node_, nmt_));
  }
  const std::int64_t watched = (store_.number(kConsumerHeartbeat) & 0xffff) * kMillisecond;
  if (watched != 0 && heard_ != 0 && now > heard_ + watched) {
    heard_ = 0;
    lose_master();
  }
}

void DriveNode::synchronise() {
  if (cut_) return;
  commanded_ = false;
  ++syncs_;
  if (!has_pending_) return;
  has_pending_ = false;
  take_command(pending_);
}

void DriveNode::send_status() {
  if (withholds_ || !operational() || !status_ || !status_->is_due(syncs_)) return;
  send(status_->frame(store_));
}

void DriveNode::send_feedback() {
  if (!operational() || !feedback_) return;
  follow_state();
  if (!frozen_) last_feedback_ = feedback_->frame(store_);
  owes_ = lags_;
  if (!lags_) send(last_feedback_);
}

}  // namespace mrroc::sim
