// What a drive reports, and its faults.
#include "drivers/socketcan/drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "canopen/emergency.hpp"
#include "drivers/socketcan/setting_list.hpp"
#include "drivers/socketcan/ticks_of.hpp"

namespace mrroc::edp {

namespace {

using namespace canopen;

constexpr double kTurn = 2 * std::numbers::pi;

/// More units than the shaft moves in one tick of homing.
std::int64_t jump(const config::DriveEntry& entry, double period) {
  const double way = 6 * std::max(entry.homing.speed_switch, entry.homing.speed_zero) * period + 0.1;
  return std::llround(way / std::abs(kTurn / entry.units_per_turn));
}

bool shares_node(const config::DriveTable& table, const config::DriveEntry& entry) {
  return std::any_of(table.drives.begin(), table.drives.end(), [&entry](const config::DriveEntry& other) {
    return other.node == entry.node && other.channel != entry.channel;
  });
}

}  // namespace

Drive::Drive(const config::DriveTable& table, const config::DriveEntry& entry, double period, double home)
    : node_(entry.node),
      pdo_node_(entry.pdo_node()),
      channel_(entry.channel),
      leads_(table.is_first_of_node(entry)),
      shares_node_(shares_node(table, entry)),
      mode_(table.mode),
      rad_per_velocity_unit_(kTurn / entry.velocity_units_per_turn),
      rated_current_(entry.rated_current),
      position_gain_(entry.position_gain),
      heartbeat_ticks_(ticks_of(kMissedHeartbeats * table.heartbeat, period)),
      answer_ticks_(ticks_of(kAnswerTime, period)),
      reversed_(entry.units_per_turn < 0),
      // the home offset of an absolute encoder is in the drive, before homing and after it
      home_(table.absolute_encoders ? 0 : home),
      pdos_(drive_pdos(table.mode)),
      setup_(entry.node, node_settings(table, entry, period)),
      display_(entry.node, of_channel(kModeDisplay, entry.channel),
               table.eds.find(of_channel(kModeDisplay, entry.channel)) != nullptr, period),
      position_(kTurn / entry.units_per_turn, table.absolute_encoders, jump(entry, period)),
      answers_(table.missed_max, table.status_every),
      power_(table.switch_on_time, period),
      homing_(table.mode, period) {}

bool Drive::take(const can::Frame& frame, Tick tick, can::Frame& next) noexcept {
  next = {};
  if (frame.error || frame.remote || frame.fd) return false;
  if (frame.id == kTransmitPdo1 + pdo_node_) {
    take_feedback(frame);
  } else if (frame.id == kTransmitPdo1 + 0x100 + pdo_node_) {
    take_status(frame);
  } else if (frame.id == kHeartbeat + node_) {
    take_heartbeat(frame, tick, next);
  } else if (const auto emergency = emergency_of(frame); emergency && emergency->node == node_) {
    take_emergency(emergency->code, tick);
  } else if (frame.id == kSdoResponse + node_) {
    take_response(frame, tick, next);
  } else {
    return false;
  }
  return true;
}

/// It is of the node: `fault` decides to which of its axes it belongs.
void Drive::take_emergency(std::uint16_t code, Tick tick) noexcept {
  if (code == 0) return;
  if (emergency_ == 0) emergency_at_ = tick;
  emergency_ = code;
}

void Drive::take_heartbeat(const can::Frame& frame, Tick tick, can::Frame& next) noexcept {
  heard_ = tick;
  if (frame.size < 1) return;
  const auto state = static_cast<NmtState>(frame.data[0] & 0x7f);
  if (state == NmtState::boot_up) {  // in service or not: its counter and its set-up are reset
    position_.lose();
    if (setup_.status() == NodeSetup::Status::writing) next = setup_.start();
    asked_ = tick;
  }
  if (answers_.in_service()) judge(state, tick);
}

/// A drive in service that is not operational has restarted, or another master has stopped it.
void Drive::judge(NmtState state, Tick tick) noexcept {
  // sent before the drive was started
  const bool stale = state != NmtState::boot_up && tick <= begun_ + heartbeat_ticks_;
  if (state == NmtState::operational || stale) return;
  restarted_ = true;
  answers_.end();
}

void Drive::take_response(const can::Frame& frame, Tick tick, can::Frame& next) noexcept {
  if (setup_.take(frame, next)) {
    asked_ = tick;
    if (setup_.forgotten()) position_.lose();  // its boot-up message was lost
  } else {
    display_.take(frame, next);
  }
  if (setup_.status() != NodeSetup::Status::done) return;
  setup_.give_up();
  begin(tick);
  next = nmt_frame(NmtCommand::start, node_);
}

void Drive::take_feedback(const can::Frame& frame) noexcept {
  std::int64_t status = 0, raw = 0, torque = 0;
  if (!pdos_.feedback.read(frame, kStatusword, false, status) ||
      !pdos_.feedback.read(frame, kPositionActual, true, raw) ||
      !pdos_.feedback.read(frame, kTorqueActual, true, torque))
    return;  // too short: ignored
  if (answers_.take()) {
    saved_ = feedback_;
    position_.save();
  }
  feedback_.statusword = static_cast<std::uint16_t>(status);
  feedback_.current = static_cast<double>(torque) / kPerMille * rated_current_ * (reversed_ ? -1 : 1);
  position_.take(raw, homing_.runs());
  if (state() != DriveState::operation_enabled) position_.hold_here();
}

void Drive::take_status(const can::Frame& frame) noexcept {
  std::int64_t velocity = 0, inputs = 0;
  if (!pdos_.status.read(frame, kVelocityActual, true, velocity) ||
      !pdos_.status.read(frame, kDigitalInputs, false, inputs))
    return;  // too short
  velocity_ = static_cast<double>(velocity) * rad_per_velocity_unit_;
  inputs_ = static_cast<std::uint32_t>(inputs);
  answers_.take_status();
}

void Drive::expect() noexcept {
  answers_.expect();
  position_.expect();
}

void Drive::close_cycle() noexcept {
  const DriveAnswers::Cycle cycle = answers_.close();
  if (cycle == DriveAnswers::Cycle::too_many) {
    feedback_ = saved_;
    position_.revert();
  } else if (cycle == DriveAnswers::Cycle::answer) {
    homing_.update(feedback_.statusword, display_);
  }
  power_.update(state());
  if (answers_.may_extrapolate()) position_.extrapolate();
}

AxisSwitches Drive::switches() const noexcept {
  AxisSwitches switches;
  const bool negative = (inputs_ & kNegativeLimitSwitch) != 0, positive = (inputs_ & kPositiveLimitSwitch) != 0;
  switches.lower_limit = reversed_ ? positive : negative;
  switches.upper_limit = reversed_ ? negative : positive;
  switches.synchro = (inputs_ & kHomeSwitch) != 0;
  return switches;
}

DriveFault Drive::fault(Tick tick) const noexcept {
  if (setup_.status() == NodeSetup::Status::refused) return SetupRefused{setup_.setting().object, setup_.abort()};
  if (restarted_) return Restarted{};
  if (answers_.has_duplicate()) return DuplicateNode{answers_.surplus()};
  if (answers_.is_missed())
    return Silent{answers_.is_alive() ? Silent::How::late : Silent::How::no_answer, answers_.missed_max()};
  if (!answers_.reports_switches()) return Silent{Silent::How::no_status, answers_.without_status_max()};
  if (tick > heard_ + heartbeat_ticks_) return HeartbeatLost{tick - heard_, heartbeat_ticks_};
  const DriveState now = state();
  const bool of_node = emergency_ != 0 && (!shares_node_ || tick > emergency_at_ + kEmergencyTicks);
  if (of_node || has_error()) return DriveError{emergency_};
  if (power_.is_wrong(now, tick)) return WrongState{feedback_.statusword};
  const bool waits_for_mode = now == DriveState::switched_on && !may_operate();
  if (power_.wanted() && (now == DriveState::operation_enabled || waits_for_mode) && !display_.confirms() &&
      mode_is_late(tick))
    return WrongMode{display_.shown(), display_.wanted()};
  const bool homed = homing() == Homing::none || homing() == Homing::attained;
  if (mode_ == DriveMode::cyclic_position && homed && now == DriveState::operation_enabled &&
      (feedback_.statusword & kFollowingError) != 0)
    return NotFollowing{};
  return {};
}

}  // namespace mrroc::edp
