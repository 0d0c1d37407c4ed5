// Commands to a drive: power, set-points, homing.
#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/socketcan/drive.hpp"

namespace mrroc::edp {

using namespace canopen;

namespace {

/// A whole number that fits `Integer`; a value beyond it becomes the nearest end, a value that is not finite 0.
template <class Integer>
std::int64_t whole(double value) noexcept {
  if (!std::isfinite(value)) return 0;
  constexpr auto kLeast = static_cast<double>(std::numeric_limits<Integer>::min());
  constexpr auto kGreatest = static_cast<double>(std::numeric_limits<Integer>::max());
  return std::llround(std::clamp(value, kLeast, kGreatest));
}

}  // namespace

void Drive::begin(Tick tick) noexcept {
  answers_.begin();
  restarted_ = false;
  heard_ = begun_ = tick;
}

void Drive::enable(bool on, Tick tick) noexcept {
  power_.enable(on, tick);
  homing_.cancel();
  display_.want(mode_);
}

void Drive::reset(Tick tick, double position, bool again, can::Frame& next) noexcept {
  next = {};
  emergency_ = 0;
  answers_.clear();
  power_.reset(tick);
  homing_.cancel();
  if (!again) {
    heard_ = tick;
    return;
  }
  answers_.end();
  feedback_.statusword = 0;  // stale
  position_.assume_position(position);
  if (!leads_) return;
  next = position_.lost() ? setup_.start() : setup_.resume();
  asked_ = tick;
}

bool Drive::repeats(Tick tick, can::Frame& next) noexcept {
  if (setup_.status() != NodeSetup::Status::writing || tick <= asked_ + answer_ticks_) return false;
  next = setup_.again();
  asked_ = tick;
  return true;
}

bool Drive::asks(Tick tick, can::Frame& request) noexcept {
  return power_.wanted() && answers_.in_service() && display_.asks(tick, request);
}

bool Drive::reset_is_done() const noexcept {
  const DriveState now = state();
  return answers_.in_service() && position_.known() && !DrivePower::has_power(now) && now != DriveState::fault &&
         now != DriveState::fault_reaction_active;
}

bool Drive::busy(Tick tick) const noexcept {
  if (power_.is_late(tick)) return false;
  if (power_.resets()) return !reset_is_done();
  if (!power_.wanted()) return answers_.is_alive() && DrivePower::has_power(state());
  return !is_on() && code_of(fault(tick)) == ErrorCode::none;
}

bool Drive::is_on() const noexcept {
  return state() == DriveState::operation_enabled && (homing() != Homing::none || display_.confirms());
}

/// The time to change the mode has passed: since the drive was switched on, or homing selected another mode.
bool Drive::mode_is_late(Tick tick) const noexcept {
  return homing_.runs() ? homing_.ticks() > power_.switch_on_ticks() : power_.is_late(tick);
}

bool Drive::may_operate() const noexcept {
  if (state() == DriveState::operation_enabled) return true;
  return state() == DriveState::switched_on && (display_.confirms() || display_.shown() == 0);
}

std::uint16_t Drive::controlword(bool release) noexcept {
  const DriveState now = state();
  const std::uint16_t word = power_.command(now, reset_is_done(), release);
  const bool starts = word == kEnableOperation && now == DriveState::operation_enabled && homing_.has_started();
  return starts ? static_cast<std::uint16_t>(word | kStartHoming) : word;
}

/// Position and velocity in the drive's units, torque in per mille of the rated one.
can::Frame Drive::command_frame(std::uint16_t controlword, double position, double velocity,
                                double torque) const noexcept {
  can::Frame frame{kReceivePdo1 + pdo_node_, {}};
  const DriveMode mode = homing_.selects_homing() ? DriveMode::homing : mode_;
  pdos_.command.write(frame, kControlword, controlword);
  pdos_.command.write(frame, kTargetPosition, whole<std::int64_t>(position));  // its low 32 bits
  pdos_.command.write(frame, kTargetVelocity, whole<std::int32_t>(velocity));
  pdos_.command.write(frame, kTargetTorque, whole<std::int16_t>(torque));
  pdos_.command.write(frame, kMode, static_cast<std::int8_t>(mode));
  return frame;
}

can::Frame Drive::command(const Target& target) noexcept {
  const std::uint16_t word = controlword(true);
  const bool on = state() == DriveState::operation_enabled && !homing_.selects_homing();
  if (!on) return command_frame(word, static_cast<double>(position_.raw()), 0, 0);
  const double error = target.position - position();
  return command_frame(word, position_.units_of(target.position),
                       (target.velocity + position_gain_ * error) / rad_per_velocity_unit_,
                       (reversed_ ? -1 : 1) * target.current / rated_current_ * kPerMille);
}

can::Frame Drive::hold(bool release) noexcept {
  const std::uint16_t word = controlword(release);
  return command_frame(word, static_cast<double>(position_.held()),
                       position_gain_ * position_.held_error() / rad_per_velocity_unit_, 0);
}

}  // namespace mrroc::edp
