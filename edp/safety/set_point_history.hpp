#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mrroc/types.hpp"

namespace mrroc::edp {

/// The shafts' set-points of the last kLength ticks, rad. `begin` comes first. The servo's thread; allocates nothing,
/// never throws.
class SetPointHistory {
 public:
  static constexpr std::size_t kLength = 512;

  /// Forgets all, and begins with these.
  void begin(const JointVector& set_points) noexcept {
    pushed_ = 0;
    push(set_points);
  }
  void push(const JointVector& set_points) noexcept { ring_[pushed_++ % kLength] = set_points; }
  /// Those of `ticks` before the last ones; the oldest that are held, when there are fewer.
  const JointVector& before(std::uint64_t ticks) const noexcept {
    const std::uint64_t back = std::min({ticks, pushed_ - 1, std::uint64_t{kLength - 1}});
    return ring_[(pushed_ - 1 - back) % kLength];
  }

 private:
  std::array<JointVector, kLength> ring_;
  std::uint64_t pushed_ = 0;
};

}  // namespace mrroc::edp
