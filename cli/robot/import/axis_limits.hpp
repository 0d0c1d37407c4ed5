#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/robot/import/findings.hpp"
#include "cli/robot/import/limits_file.hpp"
#include "cli/robot/urdf_arm.hpp"

namespace mrroc::cli {

/// The limits of one axis, each with its source: m, rad, s, N, N m.
struct AxisLimits {
  std::string name;  ///< of the axis, at most kNameLength characters
  bool slides = false;
  SourcedNumber position_min, position_max;  ///< infinite: no limit
  SourcedNumber velocity, acceleration, jerk;
  std::optional<SourcedNumber> torque;  ///< nothing: not in the file
};

/// The limits of an arm's axes: those of `given`, then those of the URDF, where a position beyond 10,000 is no limit.
/// Those that are in neither are guessed with `accept_guesses`: a velocity of pi/2 rad/s or 0.25 m/s, an acceleration
/// of the velocity / 0.4 s, a jerk of the acceleration / 0.1 s. Throws config::ConfigurationError with file and line: a
/// missing limit that may not be guessed, with the guess; a velocity, acceleration or jerk above 1e9; an empty range; a
/// range without limits of a joint that is not continuous.
std::vector<AxisLimits> limits_of_axes(const edp::Urdf& urdf, const UrdfArm& arm, const LimitsFile& given,
                                       bool accept_guesses, Findings& findings);

}  // namespace mrroc::cli
