#pragma once

#include <filesystem>
#include <kdl/chain.hpp>
#include <string>

#include "mrroc/robot_parameters.hpp"

namespace mrroc::bench {

/// A robot's URDF as KDL takes it. Fixed joints are merged into the moving ones before them: KDL is given no segment
/// to go through that does not move.
struct UrdfChain {
  KDL::Chain chain;     ///< from the root link to the link `tool_frame`
  std::string missing;  ///< why there is no such chain; else empty
};

/// There is a plain chain when the moving joints from the root to `tool_frame` are the robot's axes, by their names
/// and in their order, one for one: not in a parallel mechanism, and not where a joint follows another. Throws
/// std::runtime_error when `file` is no URDF with a link `tool_frame`.
UrdfChain urdf_chain(const std::filesystem::path& file, const RobotParameters& parameters);

}  // namespace mrroc::bench
