#pragma once

#include <optional>

#include "cli/robot/import/arm_world.hpp"
#include "cli/robot/import/findings.hpp"
#include "cli/robot/urdf_arm.hpp"

namespace mrroc::cli {

/// The largest distance of the tip from the base in 2000 random postures, m; and the sum of the distances of the
/// joints.
double reach_of(const UrdfArm& arm, const std::vector<AxisLimits>& axes);
double length_of(const UrdfArm& arm);

/// Throws config::ConfigurationError when `given` (m) differs from `reach` by more than a fifth.
void check_reach(const UrdfArm& arm, const edp::Urdf& urdf, double reach, const std::optional<double>& given);

/// Warns of axes that are parallel or perpendicular to the axis before by 1e-9 to 1e-4 rad: the inverse treats them as
/// if they were exactly so.
void note_nearly_parallel(const UrdfArm& arm, Findings& findings);

/// Throws config::ConfigurationError when MuJoCo's tool and the chain's flange differ by more than 1e-9 (m and rad) at
/// one of 100 random postures.
void check_model(const UrdfArm& arm, const std::vector<AxisLimits>& axes, const std::filesystem::path& mjcf,
                 ArmWorld& world);

/// Pairs of bodies that touch by design: in at least nine tenths of 100 random postures.
std::set<BodyPair> always_touching(const std::vector<AxisLimits>& axes, ArmWorld& world);

/// Whether no bodies but those in `excluded` touch at a posture, and with each axis turned by up to 0.6 rad (0.06 m).
bool is_free_around(const JointVector& joints, const std::vector<AxisLimits>& axes, const std::set<BodyPair>& excluded,
                    ArmWorld& world);

}  // namespace mrroc::cli
