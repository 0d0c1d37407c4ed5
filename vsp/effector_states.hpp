#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "mrroc/robot_state.hpp"

namespace mrroc::vsp {

/// The last states e_l of the robot that carries a sensor, to combine a raw reading with the state of its own tick. One
/// thread; allocates only in the constructor.
class EffectorStates {
 public:
  /// A state older than the one before it is ignored.
  void add(const RobotState& state) noexcept {
    if (count_ > 0 && state.tick <= newest()) return;
    ring_[count_ % kKept] = state;
    ++count_;
  }
  bool empty() const noexcept { return count_ == 0; }
  /// Tick of the newest; not when empty.
  Tick newest() const noexcept { return ring_[(count_ - 1) % kKept].tick; }
  /// The newest state that is not of a later tick than `tick`; null when there is no such state.
  const RobotState* at(Tick tick) const noexcept {
    for (std::size_t back = 1; back <= std::min(count_, kKept); ++back)
      if (const RobotState& state = ring_[(count_ - back) % kKept]; state.tick <= tick) return &state;
    return nullptr;
  }

 private:
  static constexpr std::size_t kKept = 64;
  std::array<RobotState, kKept> ring_{};
  std::size_t count_ = 0;
};

}  // namespace mrroc::vsp
