#include "cli/robot/type/arm_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "cli/robot/type/regulator_lines.hpp"
#include "cli/robot/type/singularities.hpp"
#include "edp/check/postures.hpp"
#include "language/joints/nearest_posture.hpp"

namespace mrroc::cli {

namespace {

using kinematics::ChainModel;

constexpr std::uint64_t kSeed = 1;
constexpr double kDegree = std::numbers::pi / 180;

std::string line_of(const AxisParameters& axis, bool slides) {
  const double unit = slides ? 1e-3 : kDegree;
  const char* const name = slides ? "mm" : "deg";
  const bool limited = std::isfinite(axis.position_min) && std::isfinite(axis.position_max);
  const std::string range =
      limited ? fmt::format("{:9.1f} to {:7.1f} {}", axis.position_min / unit, axis.position_max / unit, name)
              : std::string{"  without limits"};
  const auto part = [&](const char* key, double value, const char* of) {
    return value > 0 && std::isfinite(value) ? fmt::format("  {} {:.0f} {}/{}", key, value / unit, name, of)
                                             : std::string{};
  };
  return fmt::format("{:<28} {:<26}{}{}{}\n", axis.name, range, part("velocity", axis.velocity_max, "s"),
                     part("acceleration", axis.acceleration_max, "s2"), part("jerk", axis.jerk_max, "s3"));
}

}  // namespace

std::string report_of(const ChainModel& model, const std::string& base, const std::string& tip, int postures) {
  const RobotParameters& parameters = model.parameters();
  const ToolKinematics kinematics(model, Pose::Identity());
  const auto count = std::ssize(parameters.axes);
  std::mt19937_64 random(kSeed);
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  Eigen::AlignedBox3d box;
  int found = 0;
  for (int i = 0; i < postures; ++i) {
    const Pose pose = model.flange(edp::random_joints(model, random));
    nearest = std::min(nearest, pose.translation().norm());
    farthest = std::max(farthest, pose.translation().norm());
    box.extend(pose.translation());
    const JointVector near = edp::random_joints(model, random);
    found += nearest_posture(kinematics, pose, near).code == ErrorCode::none ? 1 : 0;
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
  text += singularity_lines(model) + regulator_lines(model);
  text += fmt::format("{:<28} {} of {} random poses within the limits are found\n", "check", found, postures);
  return text;
}

}  // namespace mrroc::cli
