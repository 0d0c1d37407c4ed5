#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mrroc::core {

/// Number of letters to insert, delete, replace or swap with their neighbour to turn one word into the other (optimal
/// string alignment distance).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of `words` nearest to `word`, the first of equals, if at most a third of its letters (at least one, fewer
/// than all) differ; else empty.
std::string nearest_word(std::string_view word, const std::vector<std::string>& words);

}  // namespace mrroc::core
