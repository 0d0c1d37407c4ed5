#pragma once

#include <Eigen/Core>
#include <string>

#include "config/deployment.hpp"

/// Parameters of a sensor type, read by `configure()` from the deployment's entry. The configuration layer has checked
/// them against the declarations in sensors/TYPE/TYPE.toml and filled in the defaults. A parameter without a
/// declaration throws SystemError(configuration).
namespace mrroc::vsp {

double number(const config::SensorEntry& entry, const std::string& key);
Eigen::Vector3d vector3(const config::SensorEntry& entry, const std::string& key);

/// Throws SystemError(configuration): "sensors.NAME.KEY: <problem>, expected <expected>".
[[noreturn]] void refuse(const config::SensorEntry& entry, const std::string& key, const std::string& problem,
                         const std::string& expected);

}  // namespace mrroc::vsp
