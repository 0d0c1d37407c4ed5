#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

#include "config/deployment.hpp"
#include "sim/world_memory.hpp"

namespace mrroc::sim {

/// A text file with what the robots of the simulated world truly did, tick by tick: for plots, and to measure how they
/// stop (mrroc/testing/motion.hpp reads it). First comes a line for every robot,
///
///     # limits <robot> <least position of each joint> <greatest of each> <greatest speed of each>
///
/// then, for every tick and robot,
///
///     <tick> <robot> <brakes: 0 or 1> <position of each joint, rad or m> <velocity of each joint, rad/s or m/s>
///
/// The simulation's thread.
class MotionFile {
 public:
  /// References must outlive it. Throws std::runtime_error when the file cannot be written.
  MotionFile(const std::filesystem::path& path, const config::Deployment& deployment, const WorldMemory& memory);
  ~MotionFile();
  MotionFile(const MotionFile&) = delete;
  MotionFile& operator=(const MotionFile&) = delete;

  /// Appends the measurements of tick `tick`.
  void write(Tick tick);

 private:
  void write_limits(const config::RobotEntry& robot);

  const config::Deployment& deployment_;
  const WorldMemory& memory_;
  std::FILE* file_;
};

}  // namespace mrroc::sim
