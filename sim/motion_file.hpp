#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

#include "config/deployment.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// A text file with the true motion of the robots of the simulated world, tick by tick: for plots, and to measure how
/// they stop (mrroc/testing/motion.hpp reads it). First comes a line for every robot,
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
  /// Writes to a copy of the descriptor `fd`; `path` is its name in messages. References must outlive it. Throws
  /// std::runtime_error when it cannot be opened.
  MotionFile(int fd, std::filesystem::path path, const config::Deployment& deployment,
             const world::WorldMemory& memory);
  ~MotionFile();
  MotionFile(const MotionFile&) = delete;
  MotionFile& operator=(const MotionFile&) = delete;

  /// Appends the measurements of tick `tick`.
  void write(Tick tick);
  /// Writes the buffered text. Returns the reason why the file is incomplete: "cannot write the motion file m: No space
  /// left on device"; empty when it is complete. Once, after the last write().
  std::string close();

 private:
  void write_limits(const config::RobotEntry& robot);

  const config::Deployment& deployment_;
  const world::WorldMemory& memory_;
  const std::filesystem::path path_;
  std::FILE* file_;
  int failure_ = 0;  // errno of the first write that failed: nothing is written after it
};

}  // namespace mrroc::sim
