#pragma once

#include <vector>

#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The last snapshots of the world, for cameras that show it late. One thread; `put` allocates nothing.
class DelayedSnapshots {
 public:
  /// Cameras show the world of `ticks` ticks before, above 0.
  explicit DelayedSnapshots(std::size_t ticks) : kept_(ticks) {}

  /// Takes the present world at every tick, and puts the one of `ticks` ticks before in its place, with the present
  /// tick; until then that of the first tick.
  void put(world::WorldSnapshot& present) noexcept;

 private:
  std::vector<world::WorldSnapshot> kept_;
  std::size_t next_ = 0;  ///< the oldest
  bool begun_ = false;
};

}  // namespace mrroc::sim
