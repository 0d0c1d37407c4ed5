#include "core/nearest_word.hpp"

#include <algorithm>
#include <limits>

namespace mrroc::core {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // rows of the table of distances between the prefixes of a and b: of i - 2, i - 1 and i letters of a
  std::vector<std::size_t> older, before(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) before[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({before[j] + 1, now[j - 1] + 1, before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], older[j - 2] + 1);
    }
    older = before;
    before = now;
  }
  return before[b.size()];
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& words) {
  std::string best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const auto& candidate : words) {
    const std::size_t allowed = std::min(candidate.size() - 1, std::max<std::size_t>(1, candidate.size() / 3));
    if (word.size() > candidate.size() + allowed) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance > allowed || distance >= least) continue;
    best = candidate;
    least = distance;
  }
  return best;
}

}  // namespace mrroc::core
