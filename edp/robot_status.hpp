#pragma once

#include "clock/wall/tick_statistics.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "links/wire/process_status.hpp"

namespace mrroc::edp {

/// What the status of an EDP counts: ticks, late commands, packages of a robot's clock. `ticks`: times of the servo's
/// wake-ups, of the real clock only. The effector's thread; allocates nothing.
links::Counters counters_of(Effector& effector, Servo& servo, const clock::TickStatistics* ticks = nullptr);

}  // namespace mrroc::edp
