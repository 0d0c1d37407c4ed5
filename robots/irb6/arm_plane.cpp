#include "robots/irb6/arm_plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mrroc::irb6 {

using Eigen::Vector3d;
using std::numbers::pi;

namespace {
constexpr double kStretch = 1e-12;  // rounding of cos(elbow) at full stretch

double least_cosine(double low, double high) {
  const bool passes_pi = std::ceil((low - pi) / (2 * pi)) * (2 * pi) + pi <= high;
  return passes_pi ? -1 : std::min(std::cos(low), std::cos(high));
}

}  // namespace

ArmAxes::ArmAxes(double column, double pitch) noexcept
    : along(std::cos(column) * std::cos(pitch), std::sin(column) * std::cos(pitch), -std::sin(pitch)),
      side(-std::sin(column), std::cos(column), 0),
      normal(std::cos(column) * std::sin(pitch), std::sin(column) * std::sin(pitch), std::cos(pitch)) {}

ArmAngles::ArmAngles(const JointVector& joints) noexcept
    : lower_arm(joints[1]), upper_arm(lower_arm + joints[2] + pi / 2), wrist(upper_arm + joints[3]) {}

ArmPlane::ArmPlane(const Geometry& geometry) noexcept
    : lower_arm_(geometry.lower_arm), upper_arm_(geometry.upper_arm), wrist_(geometry.wrist) {}

Vector3d ArmPlane::elbow(double column, const ArmAngles& angles) const noexcept {
  return lower_arm_ * ArmAxes(column, angles.lower_arm).along;
}

Vector3d ArmPlane::wrist_pitch(double column, const ArmAngles& angles) const noexcept {
  return elbow(column, angles) + upper_arm_ * ArmAxes(column, angles.upper_arm).along;
}

Vector3d ArmPlane::end(double column, const ArmAngles& angles) const noexcept {
  return wrist_pitch(column, angles) + wrist_ * ArmAxes(column, angles.wrist).along;
}

std::optional<Vector3d> ArmPlane::joints(double forward, double up, double wrist) const noexcept {
  const double e = forward - wrist_ * std::cos(wrist);  // forward and down from the shoulder to the wrist pitch axis
  const double f = -up - wrist_ * std::sin(wrist);
  const double cosine =
      (e * e + f * f - lower_arm_ * lower_arm_ - upper_arm_ * upper_arm_) / (2 * lower_arm_ * upper_arm_);
  if (!(std::abs(cosine) <= 1 + kStretch)) return std::nullopt;
  const double elbow = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double t2 = std::remainder(
      std::atan2(f, e) - std::atan2(upper_arm_ * std::sin(elbow), lower_arm_ + upper_arm_ * std::cos(elbow)), 2 * pi);
  return Vector3d(t2, elbow - pi / 2, wrist - (t2 + elbow));
}

double ArmPlane::behind(const RobotParameters& parameters, int column) const noexcept {
  const AxisParameters& lower = parameters.axes[static_cast<std::size_t>(column) + 1];
  const AxisParameters& upper = parameters.axes[static_cast<std::size_t>(column) + 2];
  const double arms = lower_arm_ * least_cosine(lower.position_min, lower.position_max) +
                      upper_arm_ * least_cosine(lower.position_min + upper.position_min + pi / 2,
                                                lower.position_max + upper.position_max + pi / 2);
  return std::max(0.0, std::abs(wrist_) - arms);
}

}  // namespace mrroc::irb6
