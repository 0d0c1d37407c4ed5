#pragma once

#include <array>
#include <string>

#include "config/entries/errors_entry.hpp"
#include "mrroc/types.hpp"

/// The errors of the simulated world as drawn from `[sim.errors]`: functions of the table and the names alone, so that
/// every process that composes the world has the same. Any thread.
namespace mrroc::sim {

/// A frame that is not where the parameter files place it: true = nominal * error, each coordinate uniform within its
/// size.
Pose error_of_base(const config::ErrorsEntry& errors, const std::string& robot);
/// Of body `link` (without the robot's prefix) on the body before.
Pose error_of_link(const config::ErrorsEntry& errors, const std::string& robot, const std::string& link);
Pose error_of_camera(const config::ErrorsEntry& errors, const std::string& sensor);

/// Reading of a force/torque sensor without load: bias + drift t, 3 forces (N, N/s), 3 torques (N m, N m/s).
struct TrueWrench {
  std::array<double, 6> bias{};
  std::array<double, 6> drift{};
};
TrueWrench error_of_wrench(const config::ErrorsEntry& errors, const std::string& sensor);

/// The true lens of a camera: its focal length is (1 + focal) times the nominal one, k1 its radial distortion.
struct TrueLens {
  double focal = 0;
  double k1 = 0;
};
TrueLens error_of_lens(const config::ErrorsEntry& errors, const std::string& sensor);
/// The age of the world that cameras show, in ticks of `period` s.
std::size_t latency_of_cameras(const config::ErrorsEntry& errors, double period) noexcept;

/// The true transmission of a joint at q (rad or m), as the encoder sees it:
///
///   reported = q + offset + gear q + amplitude (sin(q + phase) - sin(phase)) + s,  |s| <= backlash / 2.
struct TrueJoint {
  double offset = 0;
  double gear = 0;
  double amplitude = 0;
  double phase = 0;  ///< rad
  double backlash = 0;
  double friction = 0;  ///< Coulomb friction, of the axis's largest torque

  /// Without s.
  double reported(double q) const noexcept;
  /// d reported / dq.
  double slope(double q) const noexcept;
  /// The q that is reported as `value` without backlash.
  double joint(double value) const noexcept;
};
TrueJoint errors_of_joint(const config::ErrorsEntry& errors, const std::string& robot, const std::string& joint);

}  // namespace mrroc::sim
