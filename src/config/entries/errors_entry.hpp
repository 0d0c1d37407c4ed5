#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "config/table.hpp"

namespace mrroc::config {

/// Sizes of the errors of the simulated world, table `[sim.errors]`: docs/reference/simulated-errors.md. A size bounds
/// a uniform error, or it is the standard deviation of a noise. 0: the world has no such error.
struct ErrorsEntry {
  std::uint32_t seed = 1;      ///< of all random numbers
  double base_position = 0;    ///< m, each coordinate of a robot's base
  double base_rotation = 0;    ///< rad, about each of its axes
  double link_position = 0;    ///< m, each coordinate of a link on the link before
  double link_rotation = 0;    ///< rad, about each of its axes
  double joint_offset = 0;     ///< rad or m: encoder reading at the joint's zero
  double gear_ratio = 0;       ///< 1: relative error of each joint's transmission
  double eccentricity = 0;     ///< rad or m: amplitude of a transmission error with one period per 2 pi of the joint
  double backlash = 0;         ///< rad or m: total play between encoder and link
  double friction = 0;         ///< 1: Coulomb friction, of the axis's largest torque
  double current_noise = 0;    ///< 1: standard deviation, of the axis's largest torque
  double force_noise = 0;      ///< N, standard deviation of each force of a force/torque sensor
  double torque_noise = 0;     ///< N m, of each torque
  double force_bias = 0;       ///< N, reading of each force without load
  double torque_bias = 0;      ///< N m
  double force_drift = 0;      ///< N/s, of each force
  double torque_drift = 0;     ///< N m/s
  double range_noise = 0;      ///< m, standard deviation of range sensors
  double camera_position = 0;  ///< m, each coordinate of a camera on its carrier
  double camera_rotation = 0;  ///< rad, about each of its axes
  double focal_length = 0;     ///< 1: relative error of a camera's focal length
  double distortion = 0;       ///< 1: radial distortion k1 of a camera's lens
  double pixel_noise = 0;      ///< 1 of 255, standard deviation of each colour of each pixel
  double blur = 0;             ///< px: standard deviation of a camera's blur
  double camera_latency = 0;   ///< s: age of what a camera shows at the time of its picture
  double shadow = 0;           ///< 1: part of a light that its shadows take from a camera's picture
};

/// A key of `[sim.errors]` with its largest value.
struct ErrorKey {
  std::string_view name;
  double ErrorsEntry::*size;
  double max;
};

/// All sizes, in the order of `ErrorsEntry`.
const std::array<ErrorKey, 25>& error_keys();

/// The file of a set of sizes: `name` itself when it is a path (it has a '/' or ends with ".toml"), else that of
/// share/mrroc/sim/errors. It need not exist.
std::filesystem::path errors_set(const std::string& name);

/// Reads `[sim.errors]`. Key `set` names sizes that the other keys override: a set of share/mrroc/sim/errors, or a path
/// from the deployment's folder to such a file. Throws ConfigurationError.
ErrorsEntry read_errors(const Table& table);

}  // namespace mrroc::config
