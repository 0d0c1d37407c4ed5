#include "edp/check/postures.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace mrroc::edp {
namespace {

constexpr int kTriesPerPosture = 100;

/// Finite bounds of a joint's range.
struct Span {
  double low, high;
};

Span span_of(const AxisParameters& axis) {
  using std::numbers::pi;
  const bool from = std::isfinite(axis.position_min), to = std::isfinite(axis.position_max);
  if (from && to) return {axis.position_min, axis.position_max};
  if (from) return {axis.position_min, axis.position_min + 2 * pi};
  if (to) return {axis.position_max - 2 * pi, axis.position_max};
  return {-pi, pi};
}

}  // namespace

JointVector random_joints(const RobotModel& model, std::mt19937_64& random) {
  JointVector joints(model.joint_count());
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    const Span span = span_of(model.parameters().axes[static_cast<std::size_t>(i)]);
    joints[i] = std::uniform_real_distribution<double>(span.low, span.high)(random);
  }
  return joints;
}

bool within_motor_limits(const RobotModel& model, const JointVector& joints) {
  JointVector motors;
  if (model.joints_to_motors(joints, motors) != ErrorCode::none) return false;
  const auto& axes = model.parameters().axes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double motor = motors[static_cast<Eigen::Index>(i)];
    if (motor < axes[i].motor_min || motor > axes[i].motor_max) return false;
  }
  return true;
}

std::vector<JointVector> postures(const RobotModel& model, int count, std::uint64_t seed) {
  std::vector<JointVector> found{model.parameters().home};
  std::mt19937_64 random(seed);
  for (int tries = 0; tries < count * kTriesPerPosture && static_cast<int>(found.size()) <= count; ++tries) {
    const JointVector joints = random_joints(model, random);
    if (within_motor_limits(model, joints)) found.push_back(joints);
  }
  return found;
}

std::string joints_text(const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::string text;
  for (const double value : values) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%.6g", value);
    text += (text.empty() ? "(" : ", ") + std::string(number.data());
  }
  return text + ")";
}

}  // namespace mrroc::edp
