#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::task_test {

/// Tolerated overspeed of a joint, as a part of its velocity limit, where every motor obeys: the overshoot of a
/// regulator.
inline constexpr double kOvershoot = 0.05;
/// The same after a fault by which a motor does not obey or its encoder reports wrong positions. The EDP stops such a
/// joint at 1.15 of its limit, or when it would come to 1.3 of it (docs/explanation/safety.md). The joint accelerates
/// until its drive is off.
inline constexpr double kDisobedience = 0.5;

/// The true motion of one robot of the simulated world in a run, tick by tick, and the limits of its parameters.
struct Motion {
  std::vector<Tick> ticks;              ///< one after the other
  std::vector<JointVector> positions;   ///< rad or m, of each tick
  std::vector<JointVector> velocities;  ///< rad/s or m/s
  JointVector position_min, position_max, velocity_max;

  /// The first tick from which on no joint is faster than `speed` (rad/s or m/s), to the end of the run. kNever: it
  /// moved to the end. Regulators that hold a position oscillate by about 0.005 rad/s.
  Tick standstill(double speed = 0.02) const;
  /// The first tick from `from` on at which no joint is faster than `speed`, nor at the next nine: a robot that stops
  /// in the middle of a run and continues later. kNever: it did not stop.
  Tick at_rest(Tick from, double speed = 0.02) const;
  /// The greatest speed of any joint, as a part of its limit.
  double fastest() const;
  /// A description of every tick at which a joint was beyond its position limits by more than 0.01 rad (m), or faster
  /// than its velocity limit by more than `tolerance` of it. Empty: there was none.
  std::vector<std::string> limits_exceeded(double tolerance = kOvershoot) const;
};

/// Reads the file that `mrroc run --motion` has written; by robot. An unfinished last line (its writer was killed) is
/// ignored. Throws std::runtime_error that names file and line.
std::map<std::string, Motion> read_motion(const std::filesystem::path& file);

}  // namespace mrroc::task_test
