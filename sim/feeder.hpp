#pragma once

#include <random>
#include <vector>

#include "config/deployment.hpp"
#include "sim/world.hpp"

namespace mrroc::sim {

/// Puts parts into the world one after the other, each at a random position and after a random time, both from the
/// entry's seed: the same on every run.
///
/// A part waits where the scene has it, without weight and without contacts. Part k is placed at tick t_k = t_{k-1} +
/// U(interval) / period, t_0 = first / period: its frame is put, at rest, at position + U(-spread, spread), turned
/// about the world's z by U(-turn, turn). The scene must keep that position free. The simulation's thread; `feed`
/// allocates nothing.
class Feeder {
 public:
  /// `period`: servo period, s. Throws config::ConfigurationError when the scene has no such free bodies.
  Feeder(const config::FeederEntry& entry, World& world, double period);

  /// Puts the part due at `tick` into a world that is at `tick`.
  void feed(World& world, Tick tick);

 private:
  double uniform(double from, double to) noexcept;
  Pose next_place() noexcept;
  Tick ticks(double seconds) const noexcept;

  config::FeederEntry entry_;
  double period_;
  std::mt19937 random_;
  std::vector<std::size_t> parts_;  ///< indices in the world
  std::size_t fed_ = 0;
  Tick next_;
};

}  // namespace mrroc::sim
