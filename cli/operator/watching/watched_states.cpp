#include "cli/operator/watching/watched_states.hpp"

namespace mrroc::cli {

std::optional<WatchedStates> watched_of(std::string_view argument) noexcept {
  if (argument.empty() || argument == "changes") return WatchedStates{};
  if (argument == "robots") return WatchedStates{.robots = true};
  if (argument == "readings") return WatchedStates{.readings = true};
  if (argument == "world") return WatchedStates{.world = true};
  if (argument == "all") return WatchedStates{.robots = true, .readings = true, .world = true};
  return std::nullopt;
}

}  // namespace mrroc::cli
