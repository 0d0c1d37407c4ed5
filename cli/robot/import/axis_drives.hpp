#pragma once

#include <string>
#include <vector>

#include "cli/robot/import/arm_world.hpp"
#include "cli/robot/import/axis_limits.hpp"

namespace mrroc::cli {

/// What moves an arm: its own controller, or torques that the framework regulates.
enum class DriveKind { itself, torque };

/// The numbers of one axis' drive, kg m2 or kg.
struct AxisDrive {
  double inertia_min = 0, inertia_max = 0;  ///< of what it moves, within the limits
  double rotor = 0;                         ///< of rotor and gear, where torques are regulated
};

/// From 1000 random postures of the world, in which the joints have no armature yet; the rotor's is a guess. The same
/// arm gives the same numbers.
std::vector<AxisDrive> drives_of(const std::vector<AxisLimits>& axes, ArmWorld& world);

/// Table [drives] of the parameter file.
std::string drives_text(DriveKind kind);
/// The keys of one [[axes]] that belong to its drive.
std::string drive_text(DriveKind kind, const AxisLimits& axis, const AxisDrive& drive);

/// Notes what was guessed. Throws config::ConfigurationError: an axis driven by torques whose torque is in no file.
void note_drives(DriveKind kind, const std::vector<AxisLimits>& axes, const std::filesystem::path& urdf,
                 Findings& findings);

}  // namespace mrroc::cli
