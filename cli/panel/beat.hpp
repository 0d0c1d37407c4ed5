#pragma once

#include <cstdint>

#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

/// Numbers that the server sends to its browsers, and that a jog must repeat: a request that was under way for longer,
/// in a stopped process or a slow network, is recognised and moves nothing. Any thread.
class Beat {
 public:
  static constexpr std::int64_t kPeriod = 50'000'000;  ///< ns
  static constexpr std::int64_t kMaxAge = 3;           ///< periods

  std::int64_t now() const noexcept { return (clock::monotonic_ns() - start_) / kPeriod; }
  bool is_recent(std::int64_t number) const noexcept {
    const std::int64_t age = now() - number;
    return age >= 0 && age <= kMaxAge;
  }
  /// ms until the next one.
  int remaining() const noexcept {
    return static_cast<int>((kPeriod - (clock::monotonic_ns() - start_) % kPeriod) / 1'000'000) + 1;
  }

 private:
  std::int64_t start_ = clock::monotonic_ns();
};

}  // namespace mrroc::cli
