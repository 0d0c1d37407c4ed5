#pragma once

#include "mrroc/robot_model.hpp"

namespace mrroc::bench {

/// The arm of a robot's URDF, from its root to the link `tool_frame`, as the stock type has it (ChainModel): the
/// generic twin of a hand-written model. Its motors are its joints. Throws ConfigurationError when the URDF has no such
/// chain.
RobotModels chain_twin(const RobotParameters& parameters);

}  // namespace mrroc::bench
