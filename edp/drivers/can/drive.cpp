#include "edp/drivers/can/drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "canopen/emergency.hpp"

namespace mrroc::edp {

namespace {

using namespace canopen;

constexpr std::int64_t kTurnOver = std::int64_t{1} << 32;
constexpr int kMostOwed = 16;  // answers that are under way on the slowest of buses

Tick ticks(double time, double period) { return static_cast<Tick>(std::ceil(time / period)); }

}  // namespace

Drive::Drive(const config::DriveTable& table, const config::DriveEntry& entry, double period, double home)
    : node_(entry.node),
      mode_(table.mode),
      rad_per_unit_(2 * std::numbers::pi / entry.units_per_turn),
      rad_per_velocity_unit_(2 * std::numbers::pi / entry.velocity_units_per_turn),
      rated_current_(entry.rated_current),
      position_gain_(entry.position_gain),
      absolute_(table.absolute_encoders),
      heartbeat_ticks_(ticks(kMissedHeartbeats * table.heartbeat, period)),
      switch_on_ticks_(ticks(table.switch_on_time, period)),
      obey_ticks_(ticks(kObeyTime, period)),
      answer_ticks_(ticks(kAnswerTime, period)),
      select_ticks_(ticks(kSelectTime, period)),
      stale_ticks_(std::max<Tick>(3, ticks(kStaleTime, period))),
      instant_ticks_(ticks(kInstantTime, period)),
      homing_ticks_max_(ticks(kLongestHoming, period)),
      missed_max_(table.missed_max),
      without_status_max_(table.status_every * (table.missed_max + 1)),
      reversed_(entry.units_per_turn < 0),
      jump_(std::llround((6 * std::max(entry.homing.speed_switch, entry.homing.speed_zero) * period + 0.1) /
                         std::abs(rad_per_unit_))),
      pdos_(drive_pdos(table.mode)),
      setup_(entry.node, drive_settings(table, entry, period)),
      display_(entry.node, table.eds.find(kModeDisplay) != nullptr, period),
      // an absolute encoder counts as its maker's home offset says, before homing and after it
      home_(table.absolute_encoders ? 0 : home) {}

bool Drive::take(const can::Frame& frame, Tick tick, can::Frame& next) noexcept {
  next = {};
  if (frame.error || frame.remote || frame.fd) return false;
  if (frame.id == kTransmitPdo1 + node_) {
    take_feedback(frame);
  } else if (frame.id == kTransmitPdo1 + 0x100 + node_) {
    take_status(frame);
  } else if (frame.id == kHeartbeat + node_) {
    heard_ = tick;
    if (frame.size < 1) return true;
    const auto state = static_cast<NmtState>(frame.data[0] & 0x7f);
    if (state == NmtState::boot_up) {  // in service or not: it counts again, and has forgotten what it was told
      position_lost_ = true;
      if (setup_.status() == DriveSetup::Status::writing) next = setup_.start();
      asked_ = tick;
    }
    if (running_) judge(state, tick);
  } else if (const auto emergency = emergency_of(frame); emergency && emergency->node == node_) {
    if (emergency->code != 0) emergency_ = emergency->code;
  } else if (frame.id == kSdoResponse + node_) {
    if (setup_.take(frame, next)) {
      asked_ = tick;
      position_lost_ = position_lost_ || setup_.forgotten();  // no one has heard it boot
    } else {
      display_.take(frame, next);
    }
    if (setup_.status() == DriveSetup::Status::done) {
      setup_.give_up();
      begin(tick);
      next = nmt_frame(NmtCommand::start, node_);
    }
  } else {
    return false;
  }
  return true;
}

/// A drive in service that says it is not operational has restarted, or was instructed to stop by someone else.
void Drive::judge(NmtState state, Tick tick) noexcept {
  // one that has just been started may have said so before
  const bool stale = state != NmtState::boot_up && tick <= begun_ + heartbeat_ticks_;
  if (state == NmtState::operational || stale) return;
  restarted_ = true;
  running_ = was_enabled_ = false;
}

/// An axis that turns for hours passes the ends of 32 bits, by a small step; what jumps is taken as it is said.
std::int64_t Drive::unwrapped(std::int64_t raw) noexcept {
  constexpr std::int64_t kSmall = std::int64_t{1} << 24;
  for (const std::int64_t wraps : {said_.wraps - 1, said_.wraps + 1}) {
    if (std::abs(raw + wraps * kTurnOver - said_.raw) > kSmall) continue;
    said_.wraps = wraps;
    break;
  }
  return raw + said_.wraps * kTurnOver;
}

void Drive::take_feedback(const can::Frame& frame) noexcept {
  std::int64_t status = 0, raw = 0, torque = 0;
  if (!pdos_.feedback.read(frame, kStatusword, false, status) ||
      !pdos_.feedback.read(frame, kPositionActual, true, raw) ||
      !pdos_.feedback.read(frame, kTorqueActual, true, torque))
    return;  // too short: as if it had not come
  if (!spoke_) before_ = said_;
  spoke_ = true;
  count_answer();
  said_.statusword = static_cast<std::uint16_t>(status);
  take_position(raw);
  if (state() != DriveState::operation_enabled) said_.held = said_.raw;
  said_.current = static_cast<double>(torque) / kPerMille * rated_current_ * (reversed_ ? -1 : 1);
  answered_ = said_.known = true;
  unheard_ = 0;
}

void Drive::count_answer() noexcept {
  if (owed_ > 0) {
    --owed_;
    return;
  }
  unasked_ = true;
}

void Drive::take_status(const can::Frame& frame) noexcept {
  std::int64_t velocity = 0, inputs = 0;
  if (!pdos_.status.read(frame, kVelocityActual, true, velocity) ||
      !pdos_.status.read(frame, kDigitalInputs, false, inputs))
    return;  // too short
  velocity_ = static_cast<double>(velocity) * rad_per_velocity_unit_;
  inputs_ = static_cast<std::uint32_t>(inputs);
  without_status_ = 0;
  knows_switches_ = true;
}

void Drive::take_position(std::int64_t raw) noexcept {
  if (!said_.known && position_lost_) {
    said_.wraps = 0;
    // it counts from where its power came on: until it is synchronised its axis is where it was
    if (!absolute_) said_.offset += static_cast<double>(said_.raw - raw) * rad_per_unit_;
    said_.raw = raw;
    position_lost_ = !absolute_;
  }
  raw = unwrapped(raw);
  said_.increment = said_.known ? (raw - said_.real) / std::max<std::int64_t>(1, said_.since_real) : 0;
  if (homing_ == Homing::running && std::abs(raw - said_.raw) > jump_) {
    // it counts from its home position now: what it has moved meanwhile is too little to matter
    said_.offset -= static_cast<double>(raw - said_.raw) * rad_per_unit_;
    said_.increment = 0;
  }
  said_.raw = said_.real = raw;
  said_.since_real = 0;
}

/// What it said last may have been broken: it must not be what its next positions are compared with.
void Drive::go_on_from(double position) noexcept {
  said_.raw = said_.real = std::llround((position - said_.offset) / rad_per_unit_);
  said_.wraps = (said_.raw + kTurnOver / 2) >> 32;
}

void Drive::expect() noexcept {
  answered_ = false;
  owed_ = std::min(owed_ + 1, kMostOwed);
  ++said_.since_real;
  ++before_.since_real;
}

/// What comes later than that shows that it lives, not that it can be regulated.
void Drive::close_cycle() noexcept {
  if (unasked_) {
    said_ = before_;
    answered_ = false;
  } else if (spoke_) {
    follow_homing();
  }
  if (state() == DriveState::operation_enabled) was_enabled_ = wanted_;
  if (running_) ++without_status_;
  if (unasked_)
    ++surplus_;
  else if (surplus_ <= missed_max_)
    surplus_ = 0;
  spoke_ = unasked_ = false;
  if (answered_) missed_ = 0;
  if (answered_ || !running_) return;
  ++unheard_;
  if (++missed_ <= missed_max_) said_.raw += said_.increment;
}

AxisSwitches Drive::switches() const noexcept {
  AxisSwitches switches;
  const bool negative = (inputs_ & kNegativeLimitSwitch) != 0, positive = (inputs_ & kPositiveLimitSwitch) != 0;
  switches.lower_limit = reversed_ ? positive : negative;
  switches.upper_limit = reversed_ ? negative : positive;
  switches.synchro = (inputs_ & kHomeSwitch) != 0;
  return switches;
}

Drive::Finding Drive::finding(Tick tick) const noexcept {
  if (setup_.status() == DriveSetup::Status::refused) {
    const Object object = setup_.setting().object;
    return {ErrorCode::drive_restarted, static_cast<double>(object.index << 8 | object.sub),
            static_cast<double>(setup_.abort())};
  }
  if (restarted_) return {ErrorCode::drive_restarted};
  if (surplus_ > missed_max_) return {ErrorCode::encoder_fault, static_cast<double>(surplus_)};
  const auto silent = [](DriveSilence how, int syncs) {
    return Finding{ErrorCode::hardware_silent, static_cast<double>(how), static_cast<double>(syncs)};
  };
  if (missed_ > missed_max_ || !running_)
    return silent(speaks() ? DriveSilence::late : DriveSilence::no_answer, missed_max_);
  if (!tells_switches()) return silent(DriveSilence::no_status, without_status_max_);
  if (tick > heard_ + heartbeat_ticks_)
    return {ErrorCode::heartbeat_lost, static_cast<double>(tick - heard_), static_cast<double>(heartbeat_ticks_)};
  const DriveState now = state();
  if (emergency_ != 0 || now == DriveState::fault || now == DriveState::fault_reaction_active)
    return {ErrorCode::drive_fault, static_cast<double>(emergency_)};
  const bool late = tick > since_ + switch_on_ticks_;
  const bool never_on = wanted_ && now != DriveState::operation_enabled && !waiting_ && (was_enabled_ || late);
  const bool never_off = !wanted_ && has_power() && late;
  if (never_on || never_off) return {ErrorCode::drive_not_ready, static_cast<double>(said_.statusword)};
  const bool waits_for_mode = now == DriveState::switched_on && !may_operate();
  if (wanted_ && (now == DriveState::operation_enabled || waits_for_mode) && !display_.confirms() && mode_is_late(tick))
    return {ErrorCode::drive_not_ready, static_cast<double>(display_.shown()), static_cast<double>(display_.wanted())};
  if (mode_ == DriveMode::cyclic_position && (homing_ == Homing::none || homing_ == Homing::attained) &&
      now == DriveState::operation_enabled && (said_.statusword & kFollowingError) != 0)
    return {ErrorCode::following_error};
  return {};
}

}  // namespace mrroc::edp
