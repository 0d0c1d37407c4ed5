#include "sim/can/drive_node.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "canopen/emergency.hpp"

namespace mrroc::sim {

using namespace canopen;

namespace {

constexpr std::uint32_t kNotUsed = 0x80000000;
constexpr std::uint16_t kHeartbeatError = 0x8130;
constexpr std::uint16_t kPositionFollowingError = 0x8611;
constexpr std::int64_t kNoWindow = 0xffffffff;
constexpr Object kQuickStopDeceleration{0x6085};
constexpr double kUsualDeceleration = 2000;  // rad/s^2, where 6085h is 0
constexpr double kPerMille = 1000;
constexpr std::int64_t kMillisecond = 1'000'000;

}  // namespace

DriveNode::DriveNode(const config::DriveTable& table, const config::DriveEntry& entry, const AxisParameters& axis,
                     double period, Send send)
    : node_(entry.node),
      units_per_rad_(entry.units_per_turn / (2 * std::numbers::pi)),
      rated_current_(entry.rated_current),
      reversed_(entry.units_per_turn < 0),
      absolute_(table.absolute_encoders),
      send_(std::move(send)),
      store_(table.eds, entry.node),
      sdo_(entry.node, store_),
      motor_(axis, period) {}

double DriveNode::shaft(std::int64_t units) const noexcept {
  return static_cast<double>(units - raw_offset_) / units_per_rad_;
}

std::int64_t DriveNode::units(double shaft) const noexcept {
  return std::llround(shaft * units_per_rad_) + raw_offset_;
}

void DriveNode::send(const can::Frame& frame) {
  if (!cut_) send_(frame);
}

void DriveNode::boot(std::int64_t now) {
  if (!absolute_) raw_offset_ -= units(position_);
  restart(now);
}

/// All but the encoder begins anew.
void DriveNode::restart(std::int64_t now) {
  store_.reset();
  state_ = DriveState::switch_on_disabled;
  nmt_ = NmtState::pre_operational;
  store_.lock_mappings(false);
  command_.reset();
  feedback_.reset();
  status_.reset();
  controlword_ = 0;
  has_pending_ = commanded_ = homed_ = homing_failed_ = false;
  heard_ = 0;
  sent_ = now;
  send(heartbeat_frame(node_, NmtState::boot_up));
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
      if (powered() && command == NmtCommand::stop) state_ = DriveState::fault_reaction_active;
      return;
    case NmtCommand::reset_node:
    case NmtCommand::reset_communication:
      restart(now);
      return;
  }
}

/// The values of one PDO as it is configured; nothing: it is not used.
std::optional<PdoMapping> DriveNode::mapping(std::uint16_t parameters, std::uint16_t mapping_index,
                                             std::uint32_t& identifier, int& transmission) const {
  const auto raw = static_cast<std::uint32_t>(store_.number({parameters, 1}));
  if ((raw & kNotUsed) != 0 || raw == 0) return {};
  identifier = raw & 0x7ff;
  transmission = static_cast<int>(store_.number({parameters, 2}));
  std::vector<MappedObject> objects;
  for (std::int64_t i = 1; i <= store_.number({mapping_index, 0}); ++i)
    objects.push_back(MappedObject::of_entry(
        static_cast<std::uint32_t>(store_.number({mapping_index, static_cast<std::uint8_t>(i)}))));
  try {
    return PdoMapping(objects);
  } catch (const std::invalid_argument&) {
    return {};
  }
}

void DriveNode::use_pdos() {
  const auto configured = [this](std::uint16_t parameters, std::uint16_t index) {
    Pdo pdo;
    const auto map = mapping(parameters, index, pdo.identifier, pdo.transmission);
    if (!map) return std::optional<Pdo>{};
    pdo.mapping = *map;
    return std::optional<Pdo>{pdo};
  };
  command_ = configured(kReceivePdoParameters, kReceivePdoMapping);
  feedback_ = configured(kTransmitPdoParameters, kTransmitPdoMapping);
  status_ = configured(kTransmitPdoParameters + 1, kTransmitPdoMapping + 1);
}

void DriveNode::take(const can::Frame& frame, std::int64_t now) {
  if (cut_ || frame.error || frame.remote || frame.fd) return;
  if (frame.id == kNmt && frame.size == 2 && (frame.data[1] == 0 || frame.data[1] == node_)) {
    nmt(static_cast<NmtCommand>(frame.data[0]), now);
  } else if (const auto answer = sdo_.answer(frame)) {
    if (nmt_ != NmtState::stopped) send(*answer);
  } else if (operational() && command_ && frame.id == command_->identifier) {
    commanded_ = true;
    if (command_->transmission > 240) return take_command(frame);
    pending_ = frame;
    has_pending_ = true;
  } else if (const auto watched = static_cast<std::uint32_t>(store_.number(kConsumerHeartbeat));
             watched != 0 && frame.id == kHeartbeat + (watched >> 16 & 0x7f)) {
    heard_ = now;
  }
}

void DriveNode::take_command(const can::Frame& frame) {
  if (frame.size < command_->mapping.size()) return;
  for (const MappedObject& mapped : command_->mapping.objects()) {
    std::int64_t value = 0;
    if (command_->mapping.read(frame, mapped.object, true, value)) store_.set(mapped.object, value);
  }
  obey();
}

/// What the controlword and the mode ask for.
void DriveNode::obey() {
  const auto before = controlword_;
  controlword_ = static_cast<std::uint16_t>(store_.number(kControlword));
  store_.set(kModeDisplay, store_.number(kMode));
  DriveState wanted = commanded_state(state_, controlword_, before);
  if (held_back_ && wanted == DriveState::switched_on) wanted = state_;
  if (state_ == DriveState::fault && wanted != DriveState::fault) {
    store_.set(kErrorRegister, 0);
    store_.set(kErrorCode, 0);
    send(to_frame({node_, 0, 0, {}}));
  }
  state_ = wanted;
  const bool homes = store_.number(kMode) == static_cast<std::int64_t>(DriveMode::homing);
  if (!homes) return;
  const bool starts = (controlword_ & kStartHoming) != 0 && (before & kStartHoming) == 0;
  if (!starts || state_ != DriveState::operation_enabled) return;
  homed_ = homing_failed_ = false;
  const std::int64_t method = store_.number(kHomingMethod);
  if (method == 35 || method == 37) {
    raw_offset_ -= store_.number(kHomeOffset) + units(position_);
    homed_ = true;
  } else if (method == 3 || method == 5) {
    const double to_positive = (method == 3) == !reversed_ ? 1 : -1;
    const double scale = std::abs(1 / units_per_rad_);
    motor_.start_homing(to_positive, static_cast<double>(store_.number(kHomingSpeedSwitch)) * scale,
                        static_cast<double>(store_.number(kHomingSpeedZero)) * scale);
    homing_ = edp::Synchroniser::Status::running;
  } else {
    homing_failed_ = true;
  }
}

void DriveNode::look(std::int64_t now) {
  const std::int64_t produced = store_.number(kProducerHeartbeat) * kMillisecond;
  if (nmt_ != NmtState::boot_up && produced != 0 && now >= sent_ + produced) {
    sent_ = now;
    if (!hushed_) send(heartbeat_frame(node_, nmt_));
  }
  const std::int64_t watched = (store_.number(kConsumerHeartbeat) & 0xffff) * kMillisecond;
  if (watched != 0 && heard_ != 0 && now > heard_ + watched) {
    heard_ = 0;
    fail(kHeartbeatError);
  }
}

void DriveNode::measure(double position, double current, const edp::AxisSwitches& switches) {
  position_ = position;
  motor_.measure(position_, switches);
  store_.set(kPositionActual, units(position_));
  store_.set(kVelocityActual, std::llround(motor_.velocity() * units_per_rad_));
  store_.set(kTorqueActual, std::llround((reversed_ ? -current : current) / rated_current_ * kPerMille));
  const bool negative = reversed_ ? switches.upper_limit : switches.lower_limit;
  const bool positive = reversed_ ? switches.lower_limit : switches.upper_limit;
  store_.set(kDigitalInputs, (negative ? kNegativeLimitSwitch : 0) | (positive ? kPositiveLimitSwitch : 0) |
                                 (switches.synchro ? kHomeSwitch : 0));
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
  if (!operational() || !status_ || status_->transmission < 1 || status_->transmission > 240 ||
      syncs_ % status_->transmission != 0)
    return;
  can::Frame frame{status_->identifier, {}};
  for (const MappedObject& mapped : status_->mapping.objects())
    status_->mapping.write(frame, mapped.object, store_.number(mapped.object));
  send(frame);
}

void DriveNode::send_feedback() {
  if (!operational() || !feedback_) return;
  follow_state();
  can::Frame frame{feedback_->identifier, {}};
  for (const MappedObject& mapped : feedback_->mapping.objects())
    feedback_->mapping.write(frame, mapped.object, store_.number(mapped.object));
  if (!frozen_) said_ = frame;
  send(said_);
}

/// The statusword.
void DriveNode::follow_state() {
  std::uint16_t word = status_bits(state_);
  const auto mode = static_cast<DriveMode>(store_.number(kMode));
  if (mode == DriveMode::homing) {
    if (homed_) word |= kHomingAttained | kTargetReached;
    if (homing_failed_) word |= kHomingError;
  } else if (state_ == DriveState::operation_enabled) {
    word |= kFollowsCommand;
  }
  store_.set(kStatusword, word);
}

bool DriveNode::powered() const noexcept {
  return state_ == DriveState::operation_enabled || state_ == DriveState::quick_stop_active ||
         state_ == DriveState::fault_reaction_active;
}

double DriveNode::home() {
  if (homing_ != edp::Synchroniser::Status::running) return motor_.follow_velocity(0);
  const double current = motor_.follow_homing(homing_);
  if (homing_ == edp::Synchroniser::Status::failed) homing_failed_ = true;
  if (homing_ == edp::Synchroniser::Status::done) {
    raw_offset_ -= store_.number(kHomeOffset) + units(motor_.found());
    homed_ = true;
  }
  return current;
}

double DriveNode::drive() {
  if (state_ == DriveState::quick_stop_active || state_ == DriveState::fault_reaction_active) {
    const auto ramp = static_cast<double>(store_.number(kQuickStopDeceleration)) / std::abs(units_per_rad_);
    const double current = motor_.slow_down(ramp > 0 ? ramp : kUsualDeceleration);
    if (motor_.stands())
      state_ = state_ == DriveState::quick_stop_active ? DriveState::switch_on_disabled : DriveState::fault;
    return current;
  }
  if (state_ != DriveState::operation_enabled) return motor_.off();
  switch (static_cast<DriveMode>(store_.number(kMode))) {
    case DriveMode::cyclic_position: {
      const std::int64_t window = store_.number(kFollowingErrorWindow) & 0xffffffff;
      const std::int64_t target = store_.number(kTargetPosition);
      if (window != kNoWindow && window != 0 && std::abs(target - units(position_)) > window)
        fail(kPositionFollowingError);
      return motor_.follow_position(shaft(target));
    }
    case DriveMode::cyclic_velocity:
      return motor_.follow_velocity(static_cast<double>(store_.number(kTargetVelocity)) / units_per_rad_);
    case DriveMode::cyclic_torque:
      return motor_.follow_current((reversed_ ? -1 : 1) * static_cast<double>(store_.number(kTargetTorque)) /
                                   kPerMille * rated_current_);
    case DriveMode::homing:
      return home();
    case DriveMode::none:
      break;
  }
  return motor_.follow_velocity(0);
}

void DriveNode::fail(std::uint16_t code) {
  store_.set(kErrorRegister, 1);
  store_.set(kErrorCode, code);
  send(to_frame({node_, code, 1, {}}));
  state_ = powered() ? DriveState::fault_reaction_active : DriveState::fault;
}

}  // namespace mrroc::sim
