#include "cli/robot/type/arm_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "cli/robot/type/singularities.hpp"

namespace mrroc::cli {

namespace {

using kinematics::ChainModel;

constexpr std::uint64_t kSeed = 1;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLevel = 1e-12;  // by which rounding may move a joint beyond its limit

std::string line_of(const AxisParameters& axis, bool slides) {
  const double unit = slides ? 1e-3 : kDegree;
  const char* const name = slides ? "mm" : "deg";
  const bool limited = std::isfinite(axis.position_min) && std::isfinite(axis.position_max);
  const std::string range =
      limited ? fmt::format("{:9.1f} to {:7.1f} {}", axis.position_min / unit, axis.position_max / unit, name)
              : std::string{"  without limits"};
  const auto part = [&](const char* key, double value, const char* of) {
    return value > 0 ? fmt::format("  {} {:.0f} {}/{}", key, value / unit, name, of) : std::string{};
  };
  return fmt::format("{:<28} {:<26}{}{}{}\n", axis.name, range, part("velocity", axis.velocity_max, "s"),
                     part("acceleration", axis.acceleration_max, "s2"), part("jerk", axis.jerk_max, "s3"));
}

/// The same range for the random postures of an axis without limits.
double finite_or(double limit, double endless) { return std::isfinite(limit) ? limit : endless; }

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
      if (!std::isfinite(axis.position_min) || !std::isfinite(axis.position_max)) continue;
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

std::string report_of(const ChainModel& model, const std::string& base, const std::string& tip, int postures) {
  const RobotParameters& parameters = model.parameters();
  const auto count = std::ssize(parameters.axes);
  std::mt19937_64 random(kSeed);
  const auto posture = [&] {
    JointVector joints(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const AxisParameters& axis = parameters.axes[static_cast<std::size_t>(i)];
      joints[i] = std::uniform_real_distribution(finite_or(axis.position_min, -std::numbers::pi),
                                                 finite_or(axis.position_max, std::numbers::pi))(random);
    }
    return joints;
  };
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  Eigen::AlignedBox3d box;
  int found = 0;
  for (int i = 0; i < postures; ++i) {
    const Pose pose = model.flange(posture());
    nearest = std::min(nearest, pose.translation().norm());
    farthest = std::max(farthest, pose.translation().norm());
    box.extend(pose.translation());
    WithinLimits receiver(parameters);
    model.branches(pose, posture(), receiver);
    found += receiver.found() ? 1 : 0;
  }
  std::string text = fmt::format("{} axes from link {} to link {}\n", count, base, tip);
  for (int i = 0; i < count; ++i)
    text += line_of(parameters.axes[static_cast<std::size_t>(i)], model.joint_period(i) == 0);
  text += fmt::format("{:<28} {}\n", "inverse",
                      model.closed_form() ? fmt::format("closed form: {}", name_of(model.closed_form().structure()))
                                          : std::string{"numeric, within the limits"});
  text += fmt::format("{:<28} {:.3f} m, the nearest place {:.3f} m from the base\n", "reach", farthest, nearest);
  text += fmt::format("{:<28} x {:.2f} to {:.2f}, y {:.2f} to {:.2f}, z {:.2f} to {:.2f} m\n", "workspace",
                      box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(), box.max().z());
  text += singularity_lines(model);
  text += fmt::format("{:<28} {} of {} random poses within the limits are found\n", "check", found, postures);
  return text;
}

}  // namespace mrroc::cli
