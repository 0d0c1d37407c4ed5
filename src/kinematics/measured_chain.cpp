#include "kinematics/measured_chain.hpp"

#include <string>

#include "kinematics/newton.hpp"
#include "kinematics/random_numbers.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::kinematics {

namespace {

constexpr int kCompared = 20;          // postures at which the chain is compared with the model
constexpr double kSameChain = 1e-9;    // m and rad
constexpr double kLeastTurning = 0.5;  // of the angular part of a column, 0 or 1

Pose motion(const Twist& small) {
  Pose pose = Pose::Identity();
  pose.translation() = small.head<3>();
  const double angle = small.tail<3>().norm();
  if (angle > 0) pose.linear() = Eigen::AngleAxisd(angle, small.tail<3>() / angle).toRotationMatrix();
  return pose;
}

SerialChain chain_of(const RobotModel& model, const std::vector<Twist>& links) {
  const int count = model.joint_count();
  const JointVector zero = JointVector::Zero(count);
  const Eigen::Vector3d end = model.flange(zero).translation();
  const Jacobian jacobian = model.jacobian(zero, Eigen::Vector3d::Zero());
  std::vector<ChainJoint> joints;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d velocity = jacobian.col(i).head<3>(), turning = jacobian.col(i).tail<3>();
    const bool slides = turning.norm() < kLeastTurning;
    // velocity = turning x (end - point), the point nearest to the end
    const Eigen::Vector3d point = slides ? end : Eigen::Vector3d(end + turning.cross(velocity));
    Pose frame(Eigen::Translation3d(point - before));
    if (!links.empty()) frame = frame * motion(links[static_cast<std::size_t>(i)]);
    joints.push_back({frame, (slides ? velocity : turning).normalized(), slides});
    before = point;
  }
  Pose flange = model.flange(zero);
  flange.translation() -= before;
  return SerialChain(joints, flange);
}

}  // namespace

/// Compares at seeded postures.
bool is_chain(const RobotModel& model) {
  const SerialChain chain = chain_of(model, {});
  std::uint64_t state = 11;
  JointVector joints = JointVector::Zero(chain.size());
  for (int k = 0; k < kCompared; ++k) {
    for (double& joint : joints) joint = next_uniform(state) - 0.5;
    if (displacement(chain.flange(joints), model.flange(joints)).norm() >= kSameChain) return false;
  }
  return true;
}

SerialChain measured_chain(const RobotModel& model, const std::vector<Twist>& links) {
  const int count = model.joint_count();
  if (!links.empty() && std::ssize(links) != count)
    throw SystemError(ErrorCode::configuration,
                      std::to_string(links.size()) + " measured links, expected " + std::to_string(count));
  if (!is_chain(model))
    throw SystemError(ErrorCode::configuration, "the model '" + std::string(model.name()) + "' of " +
                                                    model.parameters().type +
                                                    " is not a chain of its joints, expected no measured links");
  return chain_of(model, links);
}

}  // namespace mrroc::kinematics
