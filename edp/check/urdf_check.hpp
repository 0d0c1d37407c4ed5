#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// Rejects a robot whose URDF is not the machine that its model describes. Its root link is the base frame, link
/// `flange` the flange frame, link `tool_frame` the default tool's; one of these two is required. Throws
/// ConfigurationError that names file, line, link or joint, both values.
///
/// - Every axis is a joint of this name, with the axis's position limits and velocity. An axis without limits turns
///   (`continuous`) or slides between limits of at least 1e6 m in each direction: URDF has no endless slide.
/// - At home and in 16 random postures within the limits, the same in every run, these links are where `model` has
/// them, within 1e-6 m and 1e-6 rad. Joints that are not axes mimic one, or `RobotModel::closed_loops` gives their
/// positions; links that it reports as joined have their origins within 1e-6 m.
///
/// Configuration time only.
void check_urdf(const RobotModel& model, const std::filesystem::path& file);

}  // namespace mrroc::edp
