#pragma once

#include <algorithm>
#include <concepts>

namespace mrroc::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// How often something is tried: all `times`; with a sanitizer, which is ten times slower and finds its errors on a
/// path and not by frequency, a tenth of them, at least 2.
template <std::integral Count>
constexpr Count repetitions(Count times) {
  return kSanitized ? std::max(Count{2}, times / 10) : times;
}

}  // namespace mrroc::test
