#pragma once

#include <span>

#include "testing/driver/bench.hpp"

namespace mrroc::driver_test {

/// One check. `make` throws Failure or NotMade; other exceptions are failures, too.
struct Check {
  const char* name;
  const char* says;  ///< what holds of a driver that passes
  void (*make)(Bench& bench);
};

/// In the order of their numbers, from 1: before the power, with it, with troubles, in real time, on a clock of its
/// own. Thirty-three together.
std::span<const Check> start_checks();
std::span<const Check> power_checks();
std::span<const Check> trouble_checks();
std::span<const Check> real_time_checks();
std::span<const Check> clock_checks();

}  // namespace mrroc::driver_test
