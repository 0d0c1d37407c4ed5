#pragma once

#include <filesystem>
#include <kdl/chain.hpp>
#include <string>

#include "mrroc/types.hpp"

namespace mrroc {

/// Conversion of a KDL frame.
Pose pose_of(const KDL::Frame& frame);

/// The chain of a URDF from its root link to `tip`, masses included.
KDL::Chain kdl_chain(const std::filesystem::path& urdf, const std::string& tip);

}  // namespace mrroc
