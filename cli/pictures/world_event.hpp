#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "world/world_memory.hpp"

namespace mrroc::cli {

/// The state of the simulated world in a run's event "world"; nothing for other events, and when its numbers do not fit
/// together. Any thread.
std::optional<world::WorldSnapshot> world_of_event(const nlohmann::ordered_json& event);

}  // namespace mrroc::cli
