#include "cli/robot/arm_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/chain_model.hpp"

namespace mrroc::cli {

namespace {

using edp::Urdf;
using kinematics::ChainModel;

constexpr std::uint64_t kSeed = 1;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLevel = 1e-12;  // by which rounding may move a joint beyond its limit

RobotParameters parameters_of(const UrdfArm& arm) {
  RobotParameters parameters;
  for (const Urdf::Joint& joint : arm.axes) {
    AxisParameters axis;
    axis.name = joint.name;
    axis.position_min = joint.lower.value_or(-std::numbers::pi);
    axis.position_max = joint.upper.value_or(std::numbers::pi);
    parameters.axes.push_back(axis);
  }
  return parameters;
}

std::string line_of(const Urdf::Joint& joint) {
  const bool slides = joint.type == Urdf::Type::prismatic;
  const double unit = slides ? 1e-3 : kDegree;
  const char* const name = slides ? "mm" : "deg";
  const std::string range =
      joint.lower ? fmt::format("{:9.1f} to {:7.1f} {}", *joint.lower / unit, joint.upper.value_or(0) / unit, name)
                  : std::string{"  without limits"};
  const std::string velocity = joint.velocity ? fmt::format("{:.0f} {}/s", *joint.velocity / unit, name)
                                              : std::string{"no velocity in the file"};
  return fmt::format("{:<28} {:<26} {}\n", joint.name, range, velocity);
}

/// Takes the postures that are within the limits.
class WithinLimits final : public BranchReceiver {
 public:
  explicit WithinLimits(const RobotParameters& parameters) : parameters_(parameters) {}
  void add(const JointVector& joints, bool) noexcept override { found_ = found_ || inside(joints); }
  bool found() noexcept override { return found_; }

 private:
  bool inside(const JointVector& joints) const noexcept {
    for (Eigen::Index i = 0; i < joints.size(); ++i) {
      const AxisParameters& axis = parameters_.axes[static_cast<std::size_t>(i)];
      const double middle = (axis.position_min + axis.position_max) / 2;
      const double half = (axis.position_max - axis.position_min) / 2;
      if (std::min(std::abs(joints[i] - middle), std::abs(std::remainder(joints[i] - middle, 2 * std::numbers::pi))) >
          half + kLevel)
        return false;
    }
    return true;
  }
  const RobotParameters& parameters_;
  bool found_ = false;
};

}  // namespace

std::string report_of(const UrdfArm& arm, int postures) {
  const RobotParameters parameters = parameters_of(arm);
  const auto count = std::ssize(arm.axes);
  const ChainModel model("nominal", parameters, arm.chain, JointVector::Ones(count));
  std::mt19937_64 random(kSeed);
  const auto posture = [&] {
    JointVector joints(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const AxisParameters& axis = parameters.axes[static_cast<std::size_t>(i)];
      joints[i] = std::uniform_real_distribution(axis.position_min, axis.position_max)(random);
    }
    return joints;
  };
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  int found = 0;
  for (int i = 0; i < postures; ++i) {
    const Pose pose = model.flange(posture());
    nearest = std::min(nearest, pose.translation().norm());
    farthest = std::max(farthest, pose.translation().norm());
    WithinLimits receiver(parameters);
    model.branches(pose, posture(), receiver);
    found += receiver.found() ? 1 : 0;
  }
  std::string text = fmt::format("{} axes from link {} to link {}\n", count, arm.base, arm.tip);
  for (const Urdf::Joint& joint : arm.axes) text += line_of(joint);
  text += fmt::format("{:<28} {}\n", "inverse",
                      model.closed_form() ? fmt::format("closed form: {}", name_of(model.closed_form().structure()))
                                          : std::string{"numeric, within the limits"});
  text += fmt::format("{:<28} {:.3f} m, the nearest place {:.3f} m from the base\n", "reach", farthest, nearest);
  text += fmt::format("{:<28} {} of {} random poses within the limits are found\n", "check", found, postures);
  return text;
}

}  // namespace mrroc::cli
