#pragma once

#include <Eigen/Core>
#include <string>

#include "config/deployment.hpp"

/// The sensor type's own parameters, as `configure()` reads them from a deployment's entry. The configuration layer
/// has checked them against the declarations in sensors/<type>/<type>.toml and filled in the defaults; what is missing
/// here is missing there, and throws SystemError(configuration).
namespace mrroc::vsp {

double number(const config::SensorEntry& entry, const std::string& key);
Eigen::Vector3d vector3(const config::SensorEntry& entry, const std::string& key);

/// Throws SystemError(configuration): "sensors.NAME.KEY: <problem>, expected <expected>".
[[noreturn]] void refuse(const config::SensorEntry& entry, const std::string& key, const std::string& problem,
                         const std::string& expected);

}  // namespace mrroc::vsp
