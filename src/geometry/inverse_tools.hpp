#pragma once

#include <numbers>

#include "mrroc/types.hpp"

/// Tools for the inverse kinematics of several robots. Any thread; never allocates or throws.
namespace mrroc {

/// Below this a sine of an angle or a distance (m) from an axis is a singularity: what it divides is undetermined.
inline constexpr double kSingular = 1e-10;

/// The angle `angle` + k `period` that is nearest to `near`, rad.
double nearest_angle(double angle, double near, double period = 2 * std::numbers::pi) noexcept;

}  // namespace mrroc
