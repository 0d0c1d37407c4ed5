#include "sim/errors/true_errors.hpp"

#include <cmath>
#include <numbers>

#include "geometry/rigid_motion.hpp"
#include "sim/errors/random.hpp"

namespace mrroc::sim {

namespace {

Pose frame_error(std::uint32_t seed, const std::string& device, const std::string& error, double position,
                 double rotation) {
  const ErrorNumbers places(seed, device, error + "_position"), turns(seed, device, error + "_rotation");
  const auto three = [](const ErrorNumbers& numbers, double size) {
    return Eigen::Vector3d(numbers.within(size, 0), numbers.within(size, 1), numbers.within(size, 2));
  };
  return pose_from_rpy(three(places, position), three(turns, rotation));
}

}  // namespace

Pose error_of_base(const config::ErrorsEntry& errors, const std::string& robot) {
  return frame_error(errors.seed, robot, "base", errors.base_position, errors.base_rotation);
}

Pose error_of_link(const config::ErrorsEntry& errors, const std::string& robot, const std::string& link) {
  return frame_error(errors.seed, robot + "/" + link, "link", errors.link_position, errors.link_rotation);
}

Pose error_of_camera(const config::ErrorsEntry& errors, const std::string& sensor) {
  return frame_error(errors.seed, sensor, "camera", errors.camera_position, errors.camera_rotation);
}

TrueWrench error_of_wrench(const config::ErrorsEntry& errors, const std::string& sensor) {
  const auto numbers = [&](const char* error) { return ErrorNumbers(errors.seed, sensor, error); };
  const ErrorNumbers force = numbers("force_bias"), torque = numbers("torque_bias");
  const ErrorNumbers force_drift = numbers("force_drift"), torque_drift = numbers("torque_drift");
  TrueWrench drawn;
  for (std::uint32_t i = 0; i < 3; ++i) {
    drawn.bias[i] = force.within(errors.force_bias, i);
    drawn.bias[i + 3] = torque.within(errors.torque_bias, i);
    drawn.drift[i] = force_drift.within(errors.force_drift, i);
    drawn.drift[i + 3] = torque_drift.within(errors.torque_drift, i);
  }
  return drawn;
}

TrueLens error_of_lens(const config::ErrorsEntry& errors, const std::string& sensor) {
  return {ErrorNumbers(errors.seed, sensor, "focal_length").within(errors.focal_length),
          ErrorNumbers(errors.seed, sensor, "distortion").within(errors.distortion)};
}

std::size_t latency_of_cameras(const config::ErrorsEntry& errors, double period) noexcept {
  return static_cast<std::size_t>(std::lround(errors.camera_latency / period));
}

double TrueJoint::reported(double q) const noexcept {
  return q + offset + gear * q + amplitude * (std::sin(q + phase) - std::sin(phase));
}

double TrueJoint::slope(double q) const noexcept { return 1 + gear + amplitude * std::cos(q + phase); }

double TrueJoint::joint(double value) const noexcept {
  double q = value - offset;
  for (int i = 0; i < 4; ++i) q -= (reported(q) - value) / slope(q);
  return q;
}

TrueJoint errors_of_joint(const config::ErrorsEntry& errors, const std::string& robot, const std::string& joint) {
  const auto numbers = [&](const char* error) { return ErrorNumbers(errors.seed, robot + "/" + joint, error); };
  TrueJoint drawn;
  drawn.offset = numbers("joint_offset").within(errors.joint_offset);
  drawn.gear = numbers("gear_ratio").within(errors.gear_ratio);
  drawn.amplitude = numbers("eccentricity").up_to(errors.eccentricity);
  drawn.phase = numbers("eccentricity").within(std::numbers::pi, 1);
  drawn.backlash = numbers("backlash").up_to(errors.backlash);
  drawn.friction = numbers("friction").up_to(errors.friction);
  return drawn;
}

}  // namespace mrroc::sim
