#include "sim/errors/delayed_snapshots.hpp"

#include <algorithm>
#include <utility>

namespace mrroc::sim {

void DelayedSnapshots::put(world::WorldSnapshot& present) noexcept {
  if (!std::exchange(begun_, true)) std::fill(kept_.begin(), kept_.end(), present);
  const Tick tick = present.tick;
  std::swap(present, kept_[next_]);
  present.tick = tick;
  next_ = (next_ + 1) % kept_.size();
}

}  // namespace mrroc::sim
