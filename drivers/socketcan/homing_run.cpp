#include "drivers/socketcan/homing_run.hpp"

#include <algorithm>

#include "drivers/socketcan/ticks_of.hpp"

namespace mrroc::edp {

using namespace canopen;

HomingRun::HomingRun(DriveMode usual, double period) noexcept
    : usual_(usual),
      select_ticks_(ticks_of(kSelectTime, period)),
      stale_ticks_(std::max<Tick>(3, ticks_of(kStaleTime, period))),
      instant_ticks_(ticks_of(kInstantTime, period)),
      longest_ticks_(ticks_of(kLongestTime, period)) {}

void HomingRun::begin(ModeDisplay& display) noexcept {
  phase_ = Phase::selecting;
  ticks_ = 0;
  display.want(DriveMode::homing);
}

Homing HomingRun::homing() const noexcept {
  switch (phase_) {
    case Phase::none:
      return Homing::none;
    case Phase::attained:
      return Homing::attained;
    case Phase::failed:
      return Homing::failed;
    case Phase::selecting:
    case Phase::starting:
    case Phase::moving:
    case Phase::leaving:
      break;
  }
  return Homing::running;
}

void HomingRun::update(std::uint16_t statusword, ModeDisplay& display) noexcept {
  if (!runs()) return;
  ++ticks_;
  if (phase_ == Phase::selecting) {
    if (!(display.is_available() ? display.confirms() : ticks_ >= select_ticks_)) return;
    phase_ = Phase::starting;
    ticks_ = 0;
  } else if (phase_ == Phase::leaving) {
    if (display.confirms()) phase_ = Phase::attained;
  } else if (ticks_ > stale_ticks_) {
    update_motion(statusword, display);
  }
}

void HomingRun::update_motion(std::uint16_t statusword, ModeDisplay& display) noexcept {
  const bool attained = (statusword & kHomingAttained) != 0, rests = (statusword & kTargetReached) != 0;
  if (!attained) phase_ = Phase::moving;
  if ((statusword & kHomingError) != 0 || ticks_ > longest_ticks_) {
    phase_ = Phase::failed;
  } else if (attained && rests && (phase_ == Phase::moving || ticks_ > instant_ticks_)) {
    ticks_ = 0;
    display.want(usual_);
    phase_ = display.confirms() ? Phase::attained : Phase::leaving;
  }
}

}  // namespace mrroc::edp
