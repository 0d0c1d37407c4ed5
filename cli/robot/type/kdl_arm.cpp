#include "cli/robot/type/kdl_arm.hpp"

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <vector>

#include "cli/robot/urdf_arm.hpp"

namespace mrroc::cli {

namespace {

using edp::Urdf;

KDL::Vector kdl_vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

KDL::Segment segment_of(const Urdf::Joint& joint) {
  const Eigen::Matrix3d r = joint.origin.linear();
  const KDL::Frame origin(
      KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
      kdl_vector(joint.origin.translation()));
  if (joint.type == Urdf::Type::fixed) return KDL::Segment(KDL::Joint(joint.name, KDL::Joint::Fixed), origin);
  const KDL::Joint::JointType kind = joint.type == Urdf::Type::prismatic ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
  return KDL::Segment(KDL::Joint(joint.name, origin.p, origin.M * kdl_vector(joint.axis), kind), origin);
}

}  // namespace

struct KdlArm::Solver {
  explicit Solver(const KDL::Chain& made) : chain(made), forward(chain), joints(chain.getNrOfJoints()) {}
  KDL::Chain chain;
  KDL::ChainFkSolverPos_recursive forward;
  KDL::JntArray joints;
};

KdlArm::KdlArm(const Urdf& urdf, const std::string& base, const std::string& tip) {
  const UrdfArm arm = arm_of(urdf, base, tip);
  std::vector<const Urdf::Joint*> path;
  for (std::string link = arm.tip; link != arm.base; link = path.back()->parent) path.push_back(urdf.joint_above(link));
  KDL::Chain chain;
  for (auto joint = path.rbegin(); joint != path.rend(); ++joint) chain.addSegment(segment_of(**joint));
  solver_ = std::make_unique<Solver>(chain);
}

KdlArm::~KdlArm() = default;

int KdlArm::size() const noexcept { return static_cast<int>(solver_->chain.getNrOfJoints()); }

Pose KdlArm::flange(const JointVector& joints) {
  for (Eigen::Index i = 0; i < joints.size(); ++i) solver_->joints(static_cast<unsigned>(i)) = joints[i];
  KDL::Frame frame;
  solver_->forward.JntToCart(solver_->joints, frame);
  Pose pose = Pose::Identity();
  pose.translation() << frame.p.x(), frame.p.y(), frame.p.z();
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.M.data);
  return pose;
}

}  // namespace mrroc::cli
