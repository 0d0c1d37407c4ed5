// A simulated drive's profile, CiA 402: its states, modes and errors.
#include <cmath>

#include "canopen/emergency.hpp"
#include "sim/can/drive_node.hpp"

namespace mrroc::sim {

using namespace canopen;

namespace {

constexpr std::uint16_t kPositionFollowingError = 0x8611;
constexpr std::int64_t kNoWindow = 0xffffffff;
constexpr Object kQuickStopDeceleration{0x6085};
constexpr double kUsualDeceleration = 2000;  // rad/s^2, where 6085h is 0
constexpr double kPerMille = 1000;

}  // namespace

void DriveNode::take_mode() {
  mode_ = stays_in_.value_or(static_cast<DriveMode>(store_.number(kMode)));
  store_.set(kModeDisplay, static_cast<std::int64_t>(mode_));
}

/// Executes the controlword and the mode.
void DriveNode::obey() {
  const auto before = controlword_;
  controlword_ = static_cast<std::uint16_t>(store_.number(kControlword));
  take_mode();
  DriveState wanted = commanded_state(state_, controlword_, before);
  if (held_back_ && wanted == DriveState::switched_on) wanted = state_;
  if (broken_ && state_ == DriveState::fault) wanted = state_;
  if (state_ == DriveState::fault && wanted != DriveState::fault) {
    store_.set(kErrorRegister, 0);
    store_.set(kErrorCode, 0);
    send(to_frame({node_, 0, 0, {}}));
  }
  state_ = wanted;
  if (mode_ != DriveMode::homing) return;
  const bool starts = (controlword_ & kStartHoming) != 0 && (before & kStartHoming) == 0;
  if (!starts || state_ != DriveState::operation_enabled) return;
  homed_ = homing_failed_ = false;
  const std::int64_t method = store_.number(kHomingMethod);
  if (method == 35 || method == 37) {
    raw_offset_ -= store_.number(kHomeOffset) + units(position_);
    homed_ = true;
  } else if (method == 3 || method == 5) {
    const double to_positive = (method == 3) == !reversed_ ? 1 : -1;
    const double scale = std::abs(1 / velocity_units_per_rad_);
    motor_.start_homing(to_positive, static_cast<double>(store_.number(kHomingSpeedSwitch)) * scale,
                        static_cast<double>(store_.number(kHomingSpeedZero)) * scale);
    homing_ = edp::Synchroniser::Status::running;
  } else {
    homing_failed_ = true;
  }
}

void DriveNode::measure(double position, double current, const edp::AxisSwitches& switches) {
  position_ = position;
  motor_.measure(position_, switches);
  store_.set(kPositionActual, units(position_));
  store_.set(kVelocityActual, std::llround(motor_.velocity() * velocity_units_per_rad_));
  store_.set(kTorqueActual, std::llround((reversed_ ? -current : current) / rated_current_ * kPerMille));
  const bool negative = reversed_ ? switches.upper_limit : switches.lower_limit;
  const bool positive = pressed_ || (reversed_ ? switches.lower_limit : switches.upper_limit);
  store_.set(kDigitalInputs, (negative ? kNegativeLimitSwitch : 0) | (positive ? kPositiveLimitSwitch : 0) |
                                 (switches.synchro ? kHomeSwitch : 0));
}

/// The statusword.
void DriveNode::follow_state() {
  std::uint16_t word = status_bits(state_);
  if (mode_ == DriveMode::homing) {
    if (homed_) word |= kHomingAttained | kTargetReached;
    if (homing_failed_) word |= kHomingError;
  } else if (state_ == DriveState::operation_enabled) {
    word |= kFollowsCommand;
    if (strays_ && mode_ == DriveMode::cyclic_position) word |= kFollowingError;
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
    const auto ramp = static_cast<double>(store_.number(kQuickStopDeceleration)) / std::abs(velocity_units_per_rad_);
    const double current = motor_.slow_down(ramp > 0 ? ramp : kUsualDeceleration);
    if (motor_.stands())
      state_ = state_ == DriveState::quick_stop_active ? DriveState::switch_on_disabled : DriveState::fault;
    return current;
  }
  if (state_ != DriveState::operation_enabled) return motor_.off();
  switch (mode_) {
    case DriveMode::cyclic_position: {
      const std::int64_t window = store_.number(kFollowingErrorWindow) & 0xffffffff;
      const std::int64_t target = store_.number(kTargetPosition);
      if (window != kNoWindow && window != 0 && std::abs(target - units(position_)) > window)
        fail(kPositionFollowingError);
      return motor_.follow_position(shaft(target));
    }
    case DriveMode::cyclic_velocity:
      return motor_.follow_velocity(static_cast<double>(store_.number(kTargetVelocity)) / velocity_units_per_rad_);
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

/// The reaction defined by 6007h; a fault when it defines none.
void DriveNode::lose_master() {
  switch (store_.size(kAbortConnectionOption) == 0 ? 1 : store_.number(kAbortConnectionOption)) {
    case 1:
      return fail(kHeartbeatError);
    case 2:
      state_ = DriveState::switch_on_disabled;
      return;
    case 3:
      if (state_ == DriveState::operation_enabled) state_ = DriveState::quick_stop_active;
      return;
  }
}

}  // namespace mrroc::sim
