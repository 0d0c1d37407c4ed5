#pragma once

#include <optional>
#include <string>

#include "world/world_memory.hpp"

namespace mrroc::cli {

/// What watchers of a run see of the simulated world: its newest state. The simulator stores its states only while a
/// client watches. Main thread.
class WorldFeed {
 public:
  /// `memory` outlives it; null: no world is simulated on this machine.
  explicit WorldFeed(world::WorldMemory* memory) : memory_(memory) {}

  void watch(bool wanted) noexcept;
  /// The event "world" (docs/reference/operator.md), when there is a new state.
  std::optional<std::string> take();

 private:
  world::WorldMemory* memory_;
  world::WorldSnapshot snapshot_{};
  Tick taken_ = 0;
};

}  // namespace mrroc::cli
