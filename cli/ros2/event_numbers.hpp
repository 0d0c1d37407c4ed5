#pragma once

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::cli {

// Numbers in an event of a run. Any thread.

/// Those of an array, with NaN for an element that is no number. Empty when the array is missing.
std::vector<double> numbers_of(const nlohmann::ordered_json& event, std::string_view name);
/// Of x, y, z (m) and the quaternion x, y, z, w; identity when it is missing or no pose.
Pose pose_of(const nlohmann::ordered_json& event, std::string_view name);

}  // namespace mrroc::cli
