#pragma once

#include <optional>
#include <string_view>

namespace mrroc::cli {

/// What a watching client sees beside messages, questions and changes.
struct WatchedStates {
  bool robots = false, readings = false, world = false;
};
/// Of an argument of `echo`; null when it is unknown. Any thread.
std::optional<WatchedStates> watched_of(std::string_view argument) noexcept;

}  // namespace mrroc::cli
