#include "edp/can/drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "canopen/emergency.hpp"

namespace mrroc::edp {

namespace {

using namespace canopen;

constexpr double kPerMille = 1000;
constexpr int kMostOwed = 16;  // answers that are under way on the slowest of buses

Tick ticks(double time, double period) { return static_cast<Tick>(std::ceil(time / period)); }

/// A whole number that fits `Integer`; what is beyond it, or no number, becomes the nearest end or 0.
template <class Integer>
std::int64_t whole(double value) noexcept {
  if (!std::isfinite(value)) return 0;
  constexpr auto kLeast = static_cast<double>(std::numeric_limits<Integer>::min());
  constexpr auto kGreatest = static_cast<double>(std::numeric_limits<Integer>::max());
  return std::llround(std::clamp(value, kLeast, kGreatest));
}

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
      switch_on_ticks_(ticks(kSwitchOnTime, period)),
      answer_ticks_(ticks(kAnswerTime, period)),
      select_ticks_(ticks(kSelectTime, period)),
      stale_ticks_(select_ticks_ + std::max<Tick>(3, ticks(kStaleTime, period))),
      instant_ticks_(select_ticks_ + ticks(kInstantTime, period)),
      homing_ticks_max_(ticks(kLongestHoming, period)),
      missed_max_(table.missed_max),
      without_status_max_(table.status_every * (table.missed_max + 1)),
      reversed_(entry.units_per_turn < 0),
      jump_(std::llround((6 * std::max(entry.homing.speed_switch, entry.homing.speed_zero) * period + 0.1) /
                         std::abs(rad_per_unit_))),
      pdos_(drive_pdos(table.mode)),
      setup_(entry.node, drive_settings(table, entry, period)),
      home_(home) {}

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
    if (state == NmtState::boot_up) {  // in service or not: it counts anew, and has forgotten what it was told
      position_lost_ = true;
      if (setup_.status() == DriveSetup::Status::writing) next = setup_.start();
      asked_ = tick;
    }
    if (running_) judge(state, tick);
  } else if (const auto emergency = emergency_of(frame); emergency && emergency->node == node_) {
    if (emergency->code != 0) emergency_ = emergency->code;
  } else if (frame.id == kSdoResponse + node_) {
    if (setup_.take(frame, next)) asked_ = tick;
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

/// A drive in service that says it is not operational has restarted, or was told to stop by somebody else.
void Drive::judge(NmtState state, Tick tick) noexcept {
  // one that has just been started may have said so before
  const bool stale = state != NmtState::boot_up && tick <= begun_ + heartbeat_ticks_;
  if (state == NmtState::operational || stale) return;
  restarted_ = true;
  running_ = was_enabled_ = false;
}

/// An axis that turns for hours passes the ends of 32 bits, by a small step; what jumps is taken as it is said.
std::int64_t Drive::unwrapped(std::int64_t raw) noexcept {
  constexpr std::int64_t kTurnOver = std::int64_t{1} << 32;
  constexpr std::int64_t kSmall = std::int64_t{1} << 24;
  for (const std::int64_t wraps : {wraps_ - 1, wraps_ + 1}) {
    if (std::abs(raw + wraps * kTurnOver - raw_) > kSmall) continue;
    wraps_ = wraps;
    break;
  }
  return raw + wraps_ * kTurnOver;
}

void Drive::take_feedback(const can::Frame& frame) noexcept {
  std::int64_t status = 0, raw = 0, torque = 0;
  if (!pdos_.feedback.read(frame, kStatusword, false, status) ||
      !pdos_.feedback.read(frame, kPositionActual, true, raw) ||
      !pdos_.feedback.read(frame, kTorqueActual, true, torque))
    return;  // too short: as if it had not come
  count_answer();
  statusword_ = static_cast<std::uint16_t>(status);
  take_position(raw);
  if (state() != DriveState::operation_enabled) held_ = raw_;
  current_ = static_cast<double>(torque) / kPerMille * rated_current_ * (reversed_ ? -1 : 1);
  answered_ = known_ = true;
  unheard_ = 0;
  follow_homing();
}

void Drive::count_answer() noexcept {
  if (owed_ > 0) {
    --owed_;
    return;
  }
  unasked_ = true;
  ++surplus_;
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
  if (!known_ && position_lost_) {
    wraps_ = 0;
    // it counts from where its power came on: until it is synchronised its axis is where it was
    if (!absolute_) offset_ += static_cast<double>(raw_ - raw) * rad_per_unit_;
    position_lost_ = !absolute_;
  }
  raw = unwrapped(raw);
  increment_ = known_ ? (raw - real_) / std::max<std::int64_t>(1, since_real_) : 0;
  if (homing_ == Homing::running && std::abs(raw - raw_) > jump_) {
    // it counts from its home position now: what it has moved meanwhile is too little to matter
    offset_ -= static_cast<double>(raw - raw_) * rad_per_unit_;
    increment_ = 0;
  }
  raw_ = real_ = raw;
  since_real_ = 0;
}

void Drive::expect() noexcept {
  answered_ = false;
  owed_ = std::min(owed_ + 1, kMostOwed);
  ++since_real_;
}

/// What comes later than that shows that it lives, not that it can be regulated.
void Drive::close_cycle() noexcept {
  if (state() == DriveState::operation_enabled) was_enabled_ = wanted_;
  if (running_) ++without_status_;
  if (!unasked_ && surplus_ <= missed_max_) surplus_ = 0;
  unasked_ = false;
  if (answered_) missed_ = 0;
  if (answered_ || !running_) return;
  ++unheard_;
  if (++missed_ <= missed_max_) raw_ += increment_;
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
    return {ErrorCode::drive_fault, static_cast<double>(emergency_ != 0 ? emergency_ : 0x1000)};
  const bool late = tick > since_ + switch_on_ticks_;
  const bool never_on = wanted_ && now != DriveState::operation_enabled && !waiting_ && (was_enabled_ || late);
  const bool never_off = !wanted_ && has_power() && late;
  if (never_on || never_off) return {ErrorCode::drive_not_ready, static_cast<double>(statusword_)};
  if (mode_ == DriveMode::cyclic_position && (homing_ == Homing::none || homing_ == Homing::attained) &&
      now == DriveState::operation_enabled && (statusword_ & kFollowingError) != 0)
    return {ErrorCode::following_error};
  return {};
}

void Drive::begin(Tick tick) noexcept {
  running_ = true;
  restarted_ = knows_switches_ = false;
  missed_ = unheard_ = without_status_ = 0;
  answered_ = true;  // the SYNC of this cycle came before
  heard_ = begun_ = tick;
}

void Drive::enable(bool on, Tick tick) noexcept {
  wanted_ = on;
  was_enabled_ = waiting_ = false;
  stop_ticks_ = 0;
  since_ = tick;
  homing_ = Homing::none;
}

void Drive::reset(Tick tick, can::Frame& next) noexcept {
  next = {};
  emergency_ = 0;
  surplus_ = 0;
  wanted_ = was_enabled_ = waiting_ = pulse_ = false;
  resetting_ = true;
  since_ = tick;
  homing_ = Homing::none;
  if (speaks() && tells_switches()) {
    heard_ = tick;
    return;
  }
  running_ = known_ = false;
  statusword_ = 0;  // what it said before says nothing
  next = setup_.start();
  asked_ = tick;
}

bool Drive::repeats(Tick tick, can::Frame& next) noexcept {
  if (setup_.status() != DriveSetup::Status::writing || tick <= asked_ + answer_ticks_) return false;
  next = setup_.again();
  asked_ = tick;
  return true;
}

bool Drive::has_power() const noexcept {
  return state() == DriveState::operation_enabled || state() == DriveState::quick_stop_active;
}

bool Drive::still_resetting() const noexcept {
  return !running_ || !known_ || has_power() || state() == DriveState::fault ||
         state() == DriveState::fault_reaction_active;
}

bool Drive::busy(Tick tick) const noexcept {
  if (tick > since_ + switch_on_ticks_) return false;
  if (!wanted_ && !resetting_) return speaks() && has_power();
  if (resetting_) return still_resetting();
  return wanted_ && state() != DriveState::operation_enabled && finding(tick).code == ErrorCode::none;
}

void Drive::home() noexcept {
  homing_ = Homing::running;
  homing_ticks_ = 0;
  homing_seen_ = false;
}

void Drive::follow_homing() noexcept {
  if (homing_ != Homing::running) return;
  if (++homing_ticks_ <= stale_ticks_) return;
  const bool attained = (statusword_ & kHomingAttained) != 0;
  if (!attained) homing_seen_ = true;
  if ((statusword_ & kHomingError) != 0 || homing_ticks_ > homing_ticks_max_)
    homing_ = Homing::failed;
  else if (attained && (statusword_ & kTargetReached) != 0 && (homing_seen_ || homing_ticks_ > instant_ticks_))
    homing_ = Homing::attained;
}

bool Drive::may_operate() const noexcept {
  return state() == DriveState::switched_on || state() == DriveState::operation_enabled;
}

std::uint16_t Drive::controlword(bool release) noexcept {
  const DriveState now = state();
  // a stop under way goes on to its end; one that does not come to rest loses its power all the same
  if (!wanted_ && has_power() && ++stop_ticks_ <= switch_on_ticks_) return kQuickStop;
  if (resetting_) {
    resetting_ = still_resetting();
    pulse_ = now == DriveState::fault && !pulse_;
    return pulse_ ? kFaultReset : kDisableVoltage;
  }
  if (!wanted_) return kDisableVoltage;
  waiting_ = now == DriveState::switched_on && !release;
  if (waiting_) return kSwitchOn;
  const bool starts = homing_ == Homing::running && homing_ticks_ >= select_ticks_;
  return static_cast<std::uint16_t>(towards_operation(now) |
                                    (starts && now == DriveState::operation_enabled ? kStartHoming : 0));
}

/// Position and velocity in the drive's units, torque in per mille.
can::Frame Drive::command_frame(std::uint16_t controlword, double position, double velocity,
                                double torque) const noexcept {
  can::Frame frame{kReceivePdo1 + node_, {}};
  const DriveMode mode = homing_ == Homing::running ? DriveMode::homing : mode_;
  pdos_.command.write(frame, kControlword, controlword);
  pdos_.command.write(frame, kTargetPosition, whole<std::int64_t>(position));  // its low 32 bits
  pdos_.command.write(frame, kTargetVelocity, whole<std::int32_t>(velocity));
  pdos_.command.write(frame, kTargetTorque, whole<std::int16_t>(torque));
  pdos_.command.write(frame, kMode, static_cast<std::int8_t>(mode));
  return frame;
}

can::Frame Drive::command(const Target& target) noexcept {
  const std::uint16_t word = controlword(true);
  const bool on = state() == DriveState::operation_enabled && homing_ != Homing::running;
  if (!on) return command_frame(word, static_cast<double>(raw_), 0, 0);
  const double error = target.position - position();
  return command_frame(word, (target.position - offset_) / rad_per_unit_,
                       (target.velocity + position_gain_ * error) / rad_per_velocity_unit_,
                       (reversed_ ? -1 : 1) * target.current / rated_current_ * kPerMille);
}

can::Frame Drive::hold(bool release) noexcept {
  const std::uint16_t word = controlword(release);
  const double error = static_cast<double>(held_ - raw_) * rad_per_unit_;
  return command_frame(word, static_cast<double>(held_), position_gain_ * error / rad_per_velocity_unit_, 0);
}

}  // namespace mrroc::edp
