#pragma once

#include <cstddef>
#include <vector>

namespace mrroc {

/// m, rad: positions, orientations and joints that differ by less count as one point of a path. It is above the
/// repeatability of a robot and of manual measurements; a spline through both points would have a corner there.
inline constexpr double kSamePlace = 1e-4;

/// Selects the points of 0 (the start), 1, ..., `last` that a path passes: a point near the previously kept one is
/// dropped; the last one is always kept, and points near it are dropped. `near(i, j)`: whether they count as one point.
/// Task's thread; allocates.
template <class Near>
std::vector<std::size_t> distinct_places(std::size_t last, Near near) {
  std::vector<std::size_t> kept{0};
  for (std::size_t i = 1; i < last; ++i)
    if (!near(kept.back(), i)) kept.push_back(i);
  if (last == 0) return kept;
  while (kept.size() > 1 && near(kept.back(), last)) kept.pop_back();
  kept.push_back(last);
  return kept;
}

}  // namespace mrroc
