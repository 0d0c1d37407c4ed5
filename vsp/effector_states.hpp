#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "mrroc/robot_state.hpp"

namespace mrroc::vsp {

/// The last states e_l of the robot that a sensor is mounted on, so that a raw reading can be put beside the state of
/// its own tick. One thread; allocates nothing but in the constructor.
class EffectorStates {
 public:
  /// A state older than the one before it is left out.
  void add(const RobotState& state) noexcept {
    if (count_ > 0 && state.tick <= newest()) return;
    ring_[count_ % kKept] = state;
    ++count_;
  }
  bool empty() const noexcept { return count_ == 0; }
  /// Tick of the newest; not when empty.
  Tick newest() const noexcept { return ring_[(count_ - 1) % kKept].tick; }
  /// The newest state that is not of a later tick than `tick`; null: all that are kept are later, or there is none.
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
