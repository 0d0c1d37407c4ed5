#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "config/deployment.hpp"
#include "config/table.hpp"
#include "mrroc/joint_trajectory.hpp"

namespace mrroc::config {

/// Reads a trajectory for a robot with so many axes, in their order: `points`, tables with `time` (s, rising),
/// `positions`, and in all of them or none `velocities`, with these `accelerations`; `path_tolerance` and
/// `goal_tolerance`, one number per axis, 0 for none; `goal_time_tolerance`, s. Throws ConfigurationError.
std::shared_ptr<const JointTrajectory> read_trajectory(const Table& table, std::size_t axes);

/// The same of a file with these keys alone.
std::shared_ptr<const JointTrajectory> load_trajectory(const std::filesystem::path& file, std::size_t axes);

/// The keys, as `read_trajectory` reads them.
std::string text_of(const JointTrajectory& trajectory);

}  // namespace mrroc::config
