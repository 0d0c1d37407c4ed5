#pragma once

#include <string_view>

#include "config/table.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::config {

/// Reads the table `[drives]` of a robot's parameter file: `regulates`, who closes the loops of the positions,
/// "framework" (the default) or "itself": the robot's own controller; then `interface`, what it follows, "position"
/// (the default) or "velocity", `bandwidth` (Hz, default kUsualBandwidth), and with velocities `position_gain` (1/s,
/// default a fifth of the bandwidth in rad/s). With "framework" a `bandwidth` lets it design the regulators of a
/// chain's axes. Throws ConfigurationError.
DriveParameters read_drives(const Table& file);
inline constexpr double kUsualBandwidth = 20;      ///< Hz
inline constexpr double kRegulatorPeriod = 0.002;  ///< s, of the servo ticks for which regulators are designed

/// Reads one `[[axes]]` with the keys of AxisParameters. Always required: name, limits of position, velocity,
/// acceleration and jerk. Motor, encoder, current and regulator are required where the framework regulates, too; where
/// it designs the regulators, `inertia` is in their place. Drives
/// that regulate on their own have in their place, where a key is missing: the joint as the shaft, `torque_max` as
/// `current_max`, an encoder of kUsualIncrements, a maximum following error of kUsualError, no regulator. Throws
/// ConfigurationError.
AxisParameters read_axis(const Table& table, const DriveParameters& drives);
inline constexpr double kUsualIncrements = 1 << 20;  ///< for a turn, or 2 pi m
inline constexpr double kUsualError = 0.1;           ///< rad or m

/// A number above 0. Throws ConfigurationError.
double positive(const Table& table, std::string_view key);
double positive_or(const Table& table, std::string_view key, double fallback);

}  // namespace mrroc::config
