#include "drivers/socketcan/drive_power.hpp"

#include "drivers/socketcan/ticks_of.hpp"

namespace mrroc::edp {

using namespace canopen;

DrivePower::DrivePower(double switch_on_time, double period) noexcept
    : switch_on_ticks_(ticks_of(switch_on_time, period)), obey_ticks_(ticks_of(kObeyTime, period)) {}

void DrivePower::enable(bool on, Tick tick) noexcept {
  if (resets())
    state_ = on ? State::resetting_first : State::resetting;
  else
    state_ = on ? State::switching_on : State::off;
  stop_ticks_ = 0;
  since_ = tick;
}

void DrivePower::reset(Tick tick) noexcept {
  state_ = State::resetting;
  since_ = tick;
}

void DrivePower::update(DriveState now) noexcept {
  if ((state_ == State::switching_on || state_ == State::waiting) && now == DriveState::operation_enabled)
    state_ = State::on;
}

std::uint16_t DrivePower::command(DriveState now, bool reset_done, bool release) noexcept {
  word_ = next_word(now, reset_done, release);
  return word_;
}

std::uint16_t DrivePower::next_word(DriveState now, bool reset_done, bool release) noexcept {
  // a drive that does not come to rest loses its power in the end
  stop_ticks_ = wanted() || !has_power(now) ? 0 : stop_ticks_ + 1;
  if (stop_ticks_ > 0 && stop_ticks_ <= switch_on_ticks_) return kQuickStop;
  if (resets()) {
    if (reset_done) state_ = state_ == State::resetting ? State::off : State::switching_on;
    // a rising edge resets a fault
    return now == DriveState::fault && word_ != kFaultReset ? kFaultReset : kDisableVoltage;
  }
  if (state_ == State::off) return kDisableVoltage;
  const bool waits = now == DriveState::switched_on && !release;
  if (state_ != State::on) state_ = waits ? State::waiting : State::switching_on;
  return waits ? kSwitchOn : towards_operation(now);
}

bool DrivePower::is_wrong(DriveState now, Tick tick) const noexcept {
  if (!wanted()) return has_power(now) && is_late(tick);
  if (now == DriveState::operation_enabled || state_ == State::waiting) return false;
  return state_ == State::on || is_late(tick);
}

bool DrivePower::ignores_controlword(DriveState now) const noexcept {
  const Tick way = now == DriveState::quick_stop_active ? switch_on_ticks_ : 0;
  return has_power(now) && stop_ticks_ > obey_ticks_ + way;
}

}  // namespace mrroc::edp
