#pragma once

#include <cstddef>
#include <string>

#include "config/deployment.hpp"

namespace mrroc::config {

/// A robot's entry, and its number in `Deployment::robots`.
struct RobotPlace {
  std::size_t index;
  const RobotEntry& entry;
};

/// The robot that the EDP or the simulated drives called `process` serve. Throws SystemError(configuration) when the
/// deployment has none. The deployment must outlive the result. Any thread.
RobotPlace robot_of_process(const Deployment& deployment, const std::string& process);

}  // namespace mrroc::config
