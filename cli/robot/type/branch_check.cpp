#include "cli/robot/type/branch_check.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "cli/robot/type/processor_times.hpp"
#include "edp/check/postures.hpp"
#include "kinematics/newton.hpp"
#include "language/joints/nearest_posture.hpp"

namespace mrroc::cli {

namespace {

constexpr std::uint64_t kBranchSeed = 5;
constexpr int kSpatial = 6;  // axes without redundancy

/// Looks among the branches for one posture, whole turns aside.
class Among final : public BranchReceiver {
 public:
  Among(const RobotModel& model, const JointVector& wanted) : model_(model), wanted_(wanted) {}
  void add(const JointVector& joints, bool) noexcept override {
    double difference = 0;
    for (int i = 0; i < joints.size(); ++i) {
      const double period = model_.joint_period(i), delta = joints[i] - wanted_[i];
      difference = std::max(difference, std::abs(period > 0 ? std::remainder(delta, period) : delta));
    }
    found_ = found_ || difference < BranchCheck::kSame;
  }
  bool found() noexcept override { return found_; }

 private:
  const RobotModel& model_;
  const JointVector& wanted_;
  bool found_ = false;
};

}  // namespace

BranchCheck check_branches(const kinematics::ChainModel& model, int postures) {
  const RobotParameters& parameters = model.parameters();
  const ToolKinematics kinematics(model, Pose::Identity());
  BranchCheck check;
  check.postures = postures;
  std::mt19937_64 random(kBranchSeed);
  ProcessorTimes times;
  for (int i = 0; i < postures; ++i) {
    const JointVector joints = edp::random_joints(model, random);
    const Pose pose = model.flange(joints);
    const Posture posture = times.measure([&] { return nearest_posture(kinematics, pose, parameters.home); });
    const bool reached = posture.code == ErrorCode::none;
    check.reached += reached ? 1 : 0;
    if (reached) {
      const bool there = kinematics::displacement(model.flange(posture.joints), pose).norm() < BranchCheck::kReached;
      check.outside += there && within_limits(model, posture.joints) ? 0 : 1;
    }
    if (joints.size() > kSpatial) {
      check.branches += reached ? 1 : 0;
      continue;
    }
    Among among(model, joints);
    model.branches(pose, parameters.home, among);
    check.branches += among.found() ? 1 : 0;
  }
  check.typical = times.typical();
  check.worst = times.worst();
  return check;
}

}  // namespace mrroc::cli
