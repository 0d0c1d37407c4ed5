#include "cli/robot/type/singularities.hpp"

#include <spdlog/fmt/fmt.h>

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace mrroc::cli {

namespace {

using kinematics::ChainModel;

constexpr std::uint64_t kSingularSeed = 3;
constexpr int kOthers = 5, kSteps = 720, kRefinements = 40, kSamples = 1000;
constexpr double kNear = 0.01, kSingular = 1e-6;

/// The smallest singular value of the Jacobian of one arm.
class Conditioning {
 public:
  explicit Conditioning(const ChainModel& model) : model_(model), random_(kSingularSeed) {
    for (int i = 0; i < kOthers; ++i) others_.push_back(posture());
    for (const JointVector& joints : others_) length_ = std::max(length_, model.flange(joints).translation().norm());
  }

  JointVector posture() {
    JointVector joints(std::ssize(model_.parameters().axes));
    for (int i = 0; i < joints.size(); ++i) joints[i] = std::uniform_real_distribution(min(i), max(i))(random_);
    return joints;
  }
  double min(int axis) const { return limit(axis, &AxisParameters::position_min, -std::numbers::pi); }
  double max(int axis) const { return limit(axis, &AxisParameters::position_max, std::numbers::pi); }

  double smallest(const JointVector& joints) const {
    Jacobian jacobian = model_.jacobian(joints, Eigen::Vector3d::Zero());
    jacobian.topRows<3>() /= length_;
    return Eigen::JacobiSVD<Jacobian>(jacobian).singularValues().minCoeff();
  }
  /// The largest of the smallest values with axis `axis` at `value` and the others at some postures.
  double at(int axis, double value) const {
    double largest = 0;
    for (JointVector joints : others_) {
      joints[axis] = value;
      largest = std::max(largest, smallest(joints));
    }
    return largest;
  }

 private:
  double limit(int axis, double AxisParameters::*key, double endless) const {
    const double value = model_.parameters().axes[static_cast<std::size_t>(axis)].*key;
    return std::isfinite(value) ? value : endless;
  }

  const ChainModel& model_;
  std::mt19937_64 random_;
  std::vector<JointVector> others_;
  double length_ = 1e-3;
};

/// The minimum in [left, right] by thirds.
double minimum_of(const Conditioning& arm, int axis, double left, double right) {
  for (int i = 0; i < kRefinements; ++i) {
    const double third = (right - left) / 3;
    (arm.at(axis, left + third) < arm.at(axis, right - third) ? right : left) =
        arm.at(axis, left + third) < arm.at(axis, right - third) ? right - third : left + third;
  }
  return (left + right) / 2;
}

std::vector<double> singular_positions(const Conditioning& arm, int axis) {
  std::vector<double> found;
  const double step = (arm.max(axis) - arm.min(axis)) / kSteps;
  double before = arm.at(axis, arm.min(axis) - step), here = arm.at(axis, arm.min(axis));
  for (int i = 0; i <= kSteps; ++i) {
    const double value = arm.min(axis) + i * step, after = arm.at(axis, value + step);
    if (here <= before && here < after && here < kNear) {
      const double lowest = minimum_of(arm, axis, value - step, value + step);
      const bool inside = lowest >= arm.min(axis) - kSingular && lowest <= arm.max(axis) + kSingular;
      if (inside && arm.at(axis, lowest) < kSingular) found.push_back(lowest);
    }
    before = here;
    here = after;
  }
  return found;
}

}  // namespace

std::string singularity_lines(const ChainModel& model) {
  constexpr double kDegree = std::numbers::pi / 180;
  Conditioning arm(model);
  std::string text;
  for (int axis = 0; axis < std::ssize(model.parameters().axes); ++axis) {
    const bool slides = model.joint_period(axis) == 0;
    std::string positions;
    for (const double value : singular_positions(arm, axis))
      positions += fmt::format("{}{:.1f}", positions.empty() ? "" : ", ",
                               std::round(10 * value / (slides ? 1e-3 : kDegree)) / 10 + 0.0);
    if (!positions.empty())
      text +=
          fmt::format("{:<28} with {} at {} {}\n", "singular",
                      model.parameters().axes[static_cast<std::size_t>(axis)].name, positions, slides ? "mm" : "deg");
  }
  int near = 0;
  for (int i = 0; i < kSamples; ++i) near += arm.smallest(arm.posture()) < kNear ? 1 : 0;
  return text + fmt::format("{:<28} {:.1f} % of random postures\n", "near a singularity", 100.0 * near / kSamples);
}

}  // namespace mrroc::cli
