#pragma once

#include <filesystem>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::sim {

/// The state for a picture of the world: MuJoCo's generalized positions at one tick.
struct WorldState {
  Tick tick = 0;
  double time = 0;  ///< s of simulated time
  std::vector<double> positions;
};

/// Text: "mrroc world state 1", then tick, time, the number of positions and the positions, exactly (17 digits). The
/// file appears whole or not at all (written beside it, then renamed). Throws SystemError (resources).
void save_state(const std::filesystem::path& file, const WorldState& state);

/// Throws config::ConfigurationError when `file` is not such a state.
WorldState load_state(const std::filesystem::path& file);

}  // namespace mrroc::sim
