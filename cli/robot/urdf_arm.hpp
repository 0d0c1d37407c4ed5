#pragma once

#include <string>
#include <vector>

#include "edp/check/urdf.hpp"
#include "kinematics/serial_chain.hpp"

namespace mrroc::cli {

/// The arm in a URDF: the moving joints between two links, as a chain.
struct UrdfArm {
  std::string base, tip;                       ///< links
  std::vector<edp::Urdf::Joint> axes;          ///< from the base to the tip
  std::vector<kinematics::ChainJoint> joints;  ///< of the chain
  Pose flange;                                 ///< the tip in the last joint's frame
  kinematics::SerialChain chain;
};

/// The arm from link `base` (empty: the root) to link `tip` (empty: the end of the longest arm). Throws
/// config::ConfigurationError with file and line: no such link, a tip that is not on the base, no moving joint or more
/// than kMaxJoints between them, one that follows another joint, one more than
/// 10 km from the joint before, several arms of the same length and no `tip`.
UrdfArm arm_of(const edp::Urdf& urdf, const std::string& base, const std::string& tip);

}  // namespace mrroc::cli
