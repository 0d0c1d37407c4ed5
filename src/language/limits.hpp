#pragma once

#include <string>

/// The comparison of numbers with a robot's limits, for all that check them: generators, the EDP's planner and its
/// servo. Any thread; never throws.
namespace mrroc {

/// Tolerance of every limit but jerk, for the rounding of polynomials, transmissions and inverse kinematics: relative
/// to a limit of velocity or acceleration; of a position, of joint (rad, m) or motor (rad), relative to the largest of
/// 1 and the magnitudes of the axis's finite limits. With a shaft's range of 1000 rad that is 1e-6 rad, 1/1500 of an
/// encoder increment of the IRb-6.
inline constexpr double kLimitRounding = 1e-9;
/// Relative, of the jerk: in task space accelerations are second differences of an inverse kinematics.
inline constexpr double kJerkRounding = 1e-4;

/// How far beyond `min` or `max`, which may be infinite, a position counts as within them.
double position_tolerance(double min, double max) noexcept;

/// `position` is a number from `min` to `max`, to the tolerance.
inline bool is_within(double position, double min, double max) noexcept {
  if (position >= min && position <= max) return true;  // nearly always: without the tolerance, which costs more
  const double tolerance = position_tolerance(min, max);
  return position >= min - tolerance && position <= max + tolerance;
}

/// The magnitude of `value`, a velocity, acceleration or jerk, is above `limit` by more than the relative `rounding`,
/// or `value` is not a number.
bool exceeds(double value, double limit, double rounding = kLimitRounding) noexcept;

/// The fewest significant digits, 6 to 17, with which "%.*g" prints `value` and `limit` differently where they differ.
int digits_to_differ(double value, double limit) noexcept;
/// The same, to differ from both ends of a range.
int digits_to_differ(double value, double min, double max) noexcept;

/// `value` with the digits that show how it differs from `limit`.
std::string number_text(double value, double limit);
/// "VALUE, expected MIN to MAX", with the digits that show how the value differs from both.
std::string range_text(double value, double min, double max);

}  // namespace mrroc
