#pragma once

#include <cstddef>
#include <vector>

namespace mrroc {

/// m, rad: positions, orientations and joints that differ by less are one place of a path. It is above what a robot
/// repeats and a person measures; a spline through both would have a corner there.
inline constexpr double kSamePlace = 1e-4;

/// Which of the places 0 (the start), 1, ..., `last` a path is to pass: a place that is near to the one kept before it
/// is left out; the last one is always kept, and then what is near to it is left out. `near(i, j)`: whether they are
/// one place. Task's thread; allocates.
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
