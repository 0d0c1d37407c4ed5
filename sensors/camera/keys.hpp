#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "mrroc/types.hpp"
#include "sensors/camera/intrinsics.hpp"

/// The meaning of a deployment's keys of a camera (camera.toml declares them). All functions throw
/// SystemError(configuration) naming the key, the value and the expected value.
namespace mrroc::vsp {

const std::string& text(const config::SensorEntry& entry, const std::string& key);
/// A whole number.
int whole(const config::SensorEntry& entry, const std::string& key);
/// Nothing when the key is missing; else exactly `size` numbers.
std::optional<std::vector<double>> optional_numbers(const config::SensorEntry& entry, const std::string& key,
                                                    std::size_t size);
/// `position` and `rotation`; nothing when both are missing.
std::optional<Pose> mount_pose(const config::SensorEntry& entry);
/// `mount_position` and `mount_rotation`, the mount as calibrated; nothing when both are missing.
std::optional<Pose> calibrated_mount(const config::SensorEntry& entry);
/// `intrinsics`, `distortion`, `width`, `height` of a camera of hardware; nothing when the first is missing.
std::optional<Intrinsics> given_intrinsics(const config::SensorEntry& entry);
/// "a, b, c".
std::string listed(const std::vector<std::string>& names);

}  // namespace mrroc::vsp
