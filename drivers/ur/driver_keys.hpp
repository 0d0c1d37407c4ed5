#pragma once

#include "config/key_values.hpp"
#include "drivers/ur/options.hpp"

namespace mrroc::ur {

/// The options of the keys that ur.toml declares, all of them with their values. The payload is that of the robot's
/// load, not a key. Throws std::out_of_range for a missing key.
UrOptions options_of(const config::KeyValues& keys);

}  // namespace mrroc::ur
