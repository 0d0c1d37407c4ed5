#pragma once

#include <optional>

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads the table [ros2] of the file `root`; nothing when it has none. Throws ConfigurationError: a domain outside
/// 0..230, an unknown distribution, a namespace that ROS 2 does not accept, an
/// interface that is no name.
std::optional<Ros2Entry> read_ros2(const Table& root);

/// The domain of the entry, or that which the environment's ROS_DOMAIN_ID gives every node of ROS 2, or 0. Throws
/// std::runtime_error when that is no number 0..230.
int ros2_domain(const Ros2Entry& entry);

}  // namespace mrroc::config
