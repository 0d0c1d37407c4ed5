#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// Refuses a robot whose URDF is not the machine that its model computes with. Its root link is the base frame, link
/// `flange` the flange frame, link `tool_frame` the default tool's; one of the two it must have. Throws
/// ConfigurationError that names file, line, link or joint, both values.
///
/// - Every axis is a joint of this name, with the axis's position limits and velocity. An axis without limits turns
///   (`continuous`) or slides between limits of at least 1e6 m either way: URDF has no endless slide.
/// - At home and in 16 random postures within the limits, the same ones every time, these links are where `model` has
///   them, within 1e-6 m and 1e-6 rad. Joints that are no axes mimic one, or `RobotModel::closed_loops` says where they
///   are; links that it says are joined have their origins within 1e-6 m.
///
/// Configuration time only.
void check_urdf(const RobotModel& model, const std::filesystem::path& file);

}  // namespace mrroc::edp
