#include "cli/robot/import/arm_world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "sim/scene/mujoco_messages.hpp"

namespace mrroc::cli {

namespace {

constexpr const char* kArm = "arm";

int id_of(const mjModel& model, const std::filesystem::path& mjcf, mjtObj kind, const std::string& name) {
  const int id = mj_name2id(&model, kind, (kArm + std::string("/") + name).c_str());
  if (id >= 0) return id;
  throw config::ConfigurationError(mjcf, 0, "", "no " + std::string(mju_type2Str(kind)) + " " + config::in_quotes(name),
                                   "one");
}

}  // namespace

ArmWorld::ArmWorld(const std::filesystem::path& scene, double height, const std::filesystem::path& mjcf,
                   const std::vector<std::string>& axes)
    : model_(sim::load_model(
          sim::compose(scene, {{.name = kArm, .mjcf = mjcf, .base = Pose(Eigen::Translation3d(0, 0, height))}}))),
      data_(sim::make_data(*model_)) {
  for (const std::string& axis : axes) {
    const int joint = id_of(*model_, mjcf, mjOBJ_JOINT, axis);
    positions_.push_back(model_->jnt_qposadr[joint]);
    velocities_.push_back(model_->jnt_dofadr[joint]);
  }
  tool_ = id_of(*model_, mjcf, mjOBJ_SITE, "tool");
  base_ = mj_name2id(model_.get(), mjOBJ_BODY, kArm);
}

void ArmWorld::place(const JointVector& joints) {
  for (std::size_t i = 0; i < positions_.size(); ++i) data_->qpos[positions_[i]] = joints[static_cast<Eigen::Index>(i)];
  const sim::MujocoMessages messages;
  mj_kinematics(model_.get(), data_.get());
}

Pose ArmWorld::tool(const JointVector& joints) {
  place(joints);
  const auto pose = [](const mjtNum* position, const mjtNum* rotation) {
    Pose result = Pose::Identity();
    result.translation() = Eigen::Map<const Eigen::Vector3d>(position);
    result.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation);
    return result;
  };
  const Pose base = pose(data_->xpos + 3 * base_, data_->xmat + 9 * base_);
  return base.inverse() * pose(data_->site_xpos + 3 * tool_, data_->site_xmat + 9 * tool_);
}

std::string ArmWorld::body_name(int geom) const {
  const std::string name = model_->names + model_->name_bodyadr[model_->geom_bodyid[geom]];
  const std::string prefix = kArm + std::string("/");
  return name.starts_with(prefix) ? name.substr(prefix.size()) : "";
}

std::set<BodyPair> ArmWorld::contacts(const JointVector& joints) {
  place(joints);
  const sim::MujocoMessages messages;
  mj_comPos(model_.get(), data_.get());
  mj_collision(model_.get(), data_.get());
  std::set<BodyPair> pairs;
  for (const mjContact& contact : std::span(data_->contact, static_cast<std::size_t>(data_->ncon))) {
    BodyPair pair{body_name(contact.geom1), body_name(contact.geom2)};
    if ((pair.first.empty() && pair.second.empty()) || contact.dist > 0) continue;
    if (pair.second < pair.first) std::swap(pair.first, pair.second);
    pairs.insert(pair);
  }
  return pairs;
}

JointVector ArmWorld::inertia(const JointVector& joints) {
  place(joints);
  const sim::MujocoMessages messages;
  mj_comPos(model_.get(), data_.get());
  mj_crb(model_.get(), data_.get());
  JointVector diagonal(static_cast<Eigen::Index>(velocities_.size()));
  for (std::size_t i = 0; i < velocities_.size(); ++i)
    diagonal[static_cast<Eigen::Index>(i)] = data_->qM[model_->dof_Madr[velocities_[i]]];
  return diagonal;
}

JointVector random_posture(const std::vector<AxisLimits>& axes, std::mt19937_64& random) {
  JointVector posture(std::ssize(axes));
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double endless = axes[i].slides ? 1 : std::numbers::pi;
    const double min = std::isfinite(axes[i].position_min.value) ? axes[i].position_min.value : -endless;
    const double max = std::isfinite(axes[i].position_max.value) ? axes[i].position_max.value : endless;
    posture[static_cast<Eigen::Index>(i)] = std::uniform_real_distribution(min, std::max(min, max))(random);
  }
  return posture;
}

}  // namespace mrroc::cli
