#pragma once

#include <algorithm>
#include <concepts>
#include <cstdlib>

namespace mrroc::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Number of repetitions: all `times`; with a sanitizer, which is ten times slower and finds errors by path and not by
/// frequency, a tenth of them, at least 2.
template <std::integral Count>
constexpr Count repetitions(Count times) {
  return kSanitized ? std::max(Count{2}, times / 10) : times;
}

/// Number of whole runs, each at another moment or with another seed: `usual` times in the suite, `thorough` times with
/// MRROC_TEST_THOROUGH in the environment; with a sanitizer a tenth, at least 2.
inline int tries(int usual, int thorough) {
  return repetitions(std::getenv("MRROC_TEST_THOROUGH") != nullptr ? thorough : usual);
}

}  // namespace mrroc::test
