#include "cli/robot/type/check_type.hpp"

#include <spdlog/fmt/fmt.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "cli/robot/import/arm_world.hpp"
#include "cli/robot/type/kdl_arm.hpp"
#include "config/table.hpp"
#include "kinematics/newton.hpp"

namespace mrroc::cli {

namespace {

constexpr std::uint64_t kTypeSeed = 4;
constexpr double kNearby = 0.1;  // rad or m, from the posture where an inverse begins
constexpr double kReached = 1e-8;

JointVector posture_within(const RobotParameters& parameters, std::mt19937_64& random) {
  JointVector joints(std::ssize(parameters.axes));
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const AxisParameters& axis = parameters.axes[i];
    const double min = std::isfinite(axis.position_min) ? axis.position_min : -std::numbers::pi;
    const double max = std::isfinite(axis.position_max) ? axis.position_max : std::numbers::pi;
    joints[static_cast<Eigen::Index>(i)] = std::uniform_real_distribution(min, max)(random);
  }
  return joints;
}

/// Of this thread: on a busy machine, too.
std::int64_t processor_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return now.tv_sec * std::int64_t{1000000000} + now.tv_nsec;
}

double difference(const Pose& one, const Pose& other) {
  const Twist twist = kinematics::displacement(one, other);
  return std::max(twist.head<3>().norm(), twist.tail<3>().norm());
}

}  // namespace

TypeCheck check_type(const ChainType& type, int postures) {
  const kinematics::ChainModel& model = *type.model;
  const RobotParameters& parameters = model.parameters();
  KdlArm kdl(edp::Urdf::load(type.urdf, edp::Urdf::Limits::optional), type.base, type.tip);
  if (kdl.size() != std::ssize(parameters.axes))
    throw config::ConfigurationError(type.urdf, 0, "", std::to_string(kdl.size()) + " axes from base to tip",
                                     std::to_string(parameters.axes.size()) + ", as in " + type.parameters.string());
  std::vector<std::string> names;
  for (const AxisParameters& axis : parameters.axes) names.push_back(axis.name);
  ArmWorld world(type.scene, 0, type.mjcf, names);
  TypeCheck check{.postures = postures};
  std::mt19937_64 random(kTypeSeed);
  std::vector<double> times;
  for (int i = 0; i < postures; ++i) {
    const JointVector joints = posture_within(parameters, random);
    const Pose pose = model.flange(joints);
    check.kdl = std::max(check.kdl, difference(pose, kdl.flange(joints)));
    check.mujoco = std::max(check.mujoco, difference(pose, world.tool(joints)));
    JointVector near = joints;
    for (Eigen::Index j = 0; j < near.size(); ++j) near[j] += std::uniform_real_distribution(-kNearby, kNearby)(random);
    JointVector found = near;
    const std::int64_t begin = processor_ns();
    const ErrorCode code = model.inverse(pose, near, found);
    times.push_back(1e-3 * static_cast<double>(processor_ns() - begin));
    const bool solved = code == ErrorCode::none || code == ErrorCode::singular;
    check.found += solved && difference(model.flange(found), pose) < kReached ? 1 : 0;
  }
  std::sort(times.begin(), times.end());
  check.typical = times[times.size() / 2];
  check.worst = times.back();
  return check;
}

std::string check_report(const TypeCheck& check) {
  std::string text = fmt::format("{} random postures within the limits\n", check.postures);
  text += fmt::format("{:<28} {:.1e} m or rad\n", "worst difference to KDL", check.kdl);
  text += fmt::format("{:<28} {:.1e} m or rad\n", "worst difference to MuJoCo", check.mujoco);
  text += fmt::format("{:<28} {} of {}, {:.1f} us, at most {:.1f} us\n", "inverse, from nearby", check.found,
                      check.postures, check.typical, check.worst);
  return text + (check.passed() ? "ok\n" : fmt::format("FAILED: more than {:.0e}\n", TypeCheck::kAllowed));
}

}  // namespace mrroc::cli
