#include "cli/robot/type/check_type.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "cli/robot/import/arm_world.hpp"
#include "cli/robot/type/kdl_arm.hpp"
#include "cli/robot/type/processor_times.hpp"
#include "config/table.hpp"
#include "edp/check/postures.hpp"
#include "kinematics/newton.hpp"

namespace mrroc::cli {

namespace {

constexpr std::uint64_t kTypeSeed = 4;
constexpr double kNearby = 0.1;  // rad or m, from the posture where an inverse begins

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
  TypeCheck check;
  check.postures = postures;
  std::mt19937_64 random(kTypeSeed);
  ProcessorTimes times;
  for (int i = 0; i < postures; ++i) {
    const JointVector joints = edp::random_joints(model, random);
    const Pose pose = model.flange(joints);
    check.kdl = std::max(check.kdl, difference(pose, kdl.flange(joints)));
    check.mujoco = std::max(check.mujoco, difference(pose, world.tool(joints)));
    JointVector near = joints;
    for (Eigen::Index j = 0; j < near.size(); ++j) near[j] += std::uniform_real_distribution(-kNearby, kNearby)(random);
    JointVector found = near;
    const ErrorCode code = times.measure([&] { return model.inverse(pose, near, found); });
    const bool solved = code == ErrorCode::none || code == ErrorCode::singular;
    check.found += solved && difference(model.flange(found), pose) < BranchCheck::kReached ? 1 : 0;
  }
  check.typical = times.typical();
  check.worst = times.worst();
  check.branches = check_branches(model, 2 * postures);
  return check;
}

std::string check_report(const TypeCheck& check) {
  std::string text = fmt::format("{} random postures within the limits\n", check.postures);
  text += fmt::format("{:<28} {:.1e} m or rad\n", "worst difference to KDL", check.kdl);
  text += fmt::format("{:<28} {:.1e} m or rad\n", "worst difference to MuJoCo", check.mujoco);
  text += fmt::format("{:<28} {} of {}, {:.1f} us, at most {:.1f} us\n", "inverse, from nearby", check.found,
                      check.postures, check.typical, check.worst);
  const BranchCheck& branches = check.branches;
  text += fmt::format("{:<28} {} of {}, {:.1f} us, at most {:.1f} us, {} outside the limits\n", "inverse, from home",
                      branches.reached, branches.postures, branches.typical, branches.worst, branches.outside);
  text += fmt::format("{:<28} {} of {}\n", "postures among the branches", branches.branches, branches.postures);
  if (!check.agrees()) text += fmt::format("FAILED: a difference of more than {:.0e}\n", TypeCheck::kAllowed);
  if (!branches.passed())
    text += fmt::format("FAILED: fewer than {:g} % of the branches, or a posture outside the limits\n",
                        100 * BranchCheck::kLeastBranches);
  return check.passed() ? text + "ok\n" : text;
}

}  // namespace mrroc::cli
