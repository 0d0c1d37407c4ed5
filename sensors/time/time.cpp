#include "mrroc/sensors/time.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "mrroc/errors.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

/// Fraction of a servo period: tolerance for rounding of a whole number of ticks.
constexpr double kRounding = 1e-6;

std::string condition_name(const Time& clock, double seconds) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " reached %g s", seconds);
  return clock.name() + text.data();
}

}  // namespace

Time::Time(Task& task, const std::string& name) : Sensor(task, name, "time") {}

TimeReached::TimeReached(const Time& clock, double seconds)
    : Condition(condition_name(clock, seconds)), clock_(&clock), seconds_(seconds) {
  if (!std::isfinite(seconds)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "TimeReached " + std::to_string(seconds) + " s, expected a finite time");
  }
}

bool TimeReached::holds() { return clock_->time() >= seconds_ - kRounding * clock_->task().servo_period(); }

}  // namespace mrroc
