#pragma once

#include <filesystem>
#include <kdl/chain.hpp>
#include <string>

#include "mrroc/robot_parameters.hpp"

namespace mrroc::bench {

/// A robot's URDF as a KDL chain. Fixed joints are merged into the moving joints before them, so that every segment of
/// the chain moves.
struct UrdfChain {
  KDL::Chain chain;     ///< from the root link to the link `tool_frame`
  std::string missing;  ///< why there is no such chain; empty: there is one
};

/// There is a plain chain when the moving joints from the root to `tool_frame` are the robot's axes, with their names
/// and in their order. A parallel mechanism and a joint that follows another one have no such chain. Throws
/// std::runtime_error when `file` is not a URDF with a link `tool_frame`.
UrdfChain urdf_chain(const std::filesystem::path& file, const RobotParameters& parameters);

}  // namespace mrroc::bench
