// What a drive is told: its way to operation and back, its set-points, homing.
#include <algorithm>
#include <cmath>
#include <limits>

#include "edp/drivers/can/drive.hpp"

namespace mrroc::edp {

using namespace canopen;

namespace {

/// A whole number that fits `Integer`; what is beyond it, or no number, becomes the nearest end or 0.
template <class Integer>
std::int64_t whole(double value) noexcept {
  if (!std::isfinite(value)) return 0;
  constexpr auto kLeast = static_cast<double>(std::numeric_limits<Integer>::min());
  constexpr auto kGreatest = static_cast<double>(std::numeric_limits<Integer>::max());
  return std::llround(std::clamp(value, kLeast, kGreatest));
}

}  // namespace

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
  display_.want(mode_);
}

void Drive::reset(Tick tick, double position, can::Frame& next) noexcept {
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
  running_ = said_.known = false;
  said_.statusword = 0;  // what it said before says nothing
  go_on_from(position);
  next = position_lost_ ? setup_.start() : setup_.resume();
  asked_ = tick;
}

bool Drive::repeats(Tick tick, can::Frame& next) noexcept {
  if (setup_.status() != DriveSetup::Status::writing || tick <= asked_ + answer_ticks_) return false;
  next = setup_.again();
  asked_ = tick;
  return true;
}

bool Drive::asks(Tick tick, can::Frame& request) noexcept {
  return wanted_ && running_ && display_.asks(tick, request);
}

bool Drive::has_power() const noexcept {
  return state() == DriveState::operation_enabled || state() == DriveState::quick_stop_active;
}

bool Drive::defies() const noexcept {
  const bool stops = state() == DriveState::quick_stop_active;
  return running_ && has_power() && stop_ticks_ > obey_ticks_ + (stops ? switch_on_ticks_ : 0);
}

bool Drive::still_resetting() const noexcept {
  return !running_ || !said_.known || has_power() || state() == DriveState::fault ||
         state() == DriveState::fault_reaction_active;
}

bool Drive::busy(Tick tick) const noexcept {
  if (tick > since_ + switch_on_ticks_) return false;
  if (!wanted_ && !resetting_) return speaks() && has_power();
  if (resetting_) return still_resetting();
  return wanted_ && !is_on() && finding(tick).code == ErrorCode::none;
}

bool Drive::is_on() const noexcept {
  return state() == DriveState::operation_enabled && (homing_ != Homing::none || display_.confirms());
}

/// Since it was switched on, or since the part of homing that wants another one has begun.
bool Drive::mode_is_late(Tick tick) const noexcept {
  return homing_ == Homing::running ? homing_ticks_ > switch_on_ticks_ : tick > since_ + switch_on_ticks_;
}

void Drive::home() noexcept {
  homing_ = Homing::running;
  homing_ticks_ = 0;
  homing_started_ = homing_seen_ = homed_ = false;
  display_.want(DriveMode::homing);
}

/// It changes its mode, homes, and changes it back.
void Drive::follow_homing() noexcept {
  if (homing_ != Homing::running) return;
  ++homing_ticks_;
  if (!homing_started_) {
    homing_started_ = display_.tells() ? display_.confirms() : homing_ticks_ >= select_ticks_;
    if (homing_started_) homing_ticks_ = 0;
  } else if (!homed_) {
    follow_homing_run();
  } else if (display_.confirms()) {
    homing_ = Homing::attained;
  }
}

void Drive::follow_homing_run() noexcept {
  if (homing_ticks_ <= stale_ticks_) return;
  const bool attained = (said_.statusword & kHomingAttained) != 0;
  if (!attained) homing_seen_ = true;
  if ((said_.statusword & kHomingError) != 0 || homing_ticks_ > homing_ticks_max_) {
    homing_ = Homing::failed;
  } else if (attained && (said_.statusword & kTargetReached) != 0 && (homing_seen_ || homing_ticks_ > instant_ticks_)) {
    homed_ = true;
    homing_ticks_ = 0;
    display_.want(mode_);
    if (display_.confirms()) homing_ = Homing::attained;
  }
}

bool Drive::may_operate() const noexcept {
  if (state() == DriveState::operation_enabled) return true;
  return state() == DriveState::switched_on && (display_.confirms() || display_.shown() == 0);
}

std::uint16_t Drive::controlword(bool release) noexcept {
  const DriveState now = state();
  // a stop under way continues to its end; one that does not come to rest loses its power all the same
  stop_ticks_ = wanted_ || !has_power() ? 0 : stop_ticks_ + 1;
  if (stop_ticks_ > 0 && stop_ticks_ <= switch_on_ticks_) return kQuickStop;
  if (resetting_) {
    resetting_ = still_resetting();
    pulse_ = now == DriveState::fault && !pulse_;
    return pulse_ ? kFaultReset : kDisableVoltage;
  }
  if (!wanted_) return kDisableVoltage;
  waiting_ = now == DriveState::switched_on && !release;
  if (waiting_) return kSwitchOn;
  const bool starts = homes() && homing_started_ && now == DriveState::operation_enabled;
  return static_cast<std::uint16_t>(towards_operation(now) | (starts ? kStartHoming : 0));
}

/// Position and velocity in the drive's units, torque in per mille.
can::Frame Drive::command_frame(std::uint16_t controlword, double position, double velocity,
                                double torque) const noexcept {
  can::Frame frame{kReceivePdo1 + node_, {}};
  const DriveMode mode = homes() ? DriveMode::homing : mode_;
  pdos_.command.write(frame, kControlword, controlword);
  pdos_.command.write(frame, kTargetPosition, whole<std::int64_t>(position));  // its low 32 bits
  pdos_.command.write(frame, kTargetVelocity, whole<std::int32_t>(velocity));
  pdos_.command.write(frame, kTargetTorque, whole<std::int16_t>(torque));
  pdos_.command.write(frame, kMode, static_cast<std::int8_t>(mode));
  return frame;
}

can::Frame Drive::command(const Target& target) noexcept {
  const std::uint16_t word = controlword(true);
  const bool on = state() == DriveState::operation_enabled && !homes();
  if (!on) return command_frame(word, static_cast<double>(said_.raw), 0, 0);
  const double error = target.position - position();
  return command_frame(word, (target.position - said_.offset) / rad_per_unit_,
                       (target.velocity + position_gain_ * error) / rad_per_velocity_unit_,
                       (reversed_ ? -1 : 1) * target.current / rated_current_ * kPerMille);
}

can::Frame Drive::hold(bool release) noexcept {
  const std::uint16_t word = controlword(release);
  const double error = static_cast<double>(said_.held - said_.raw) * rad_per_unit_;
  return command_frame(word, static_cast<double>(said_.held), position_gain_ * error / rad_per_velocity_unit_, 0);
}

}  // namespace mrroc::edp
