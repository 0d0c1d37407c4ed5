#include "cli/robot/import/home.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>

#include "cli/robot/import/arm_world.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::cli {

namespace {

using kinematics::ChainModel;

constexpr std::uint64_t kHomeSeed = 1;
constexpr int kPostures = 2000, kAsked = 300;
constexpr double kMiddle = 0.85;               // of a range
constexpr double kDownFirst = 10;              // of the score: the tool points down
constexpr double kFarTurn = std::numbers::pi;  // rad: beyond, an axis without limits is wound up
constexpr double kRound = 1000;                // of 1 rad, 1 m: home is a round number

struct Candidate {
  JointVector joints;
  double score;
};

/// Collects the postures of one pose.
class Collected final : public BranchReceiver {
 public:
  void add(const JointVector& joints, bool) noexcept override { postures.push_back(joints); }
  bool found() noexcept override { return postures.size() >= 16; }
  std::vector<JointVector> postures;
};

bool in_the_middle(const JointVector& joints, const std::vector<AxisLimits>& axes) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double value = joints[static_cast<Eigen::Index>(i)];
    const double min = axes[i].position_min.value, max = axes[i].position_max.value;
    if (!axes[i].slides && std::abs(value) > kFarTurn) return false;
    if (std::isfinite(min) && std::isfinite(max) && std::abs(value - (min + max) / 2) > kMiddle * (max - min) / 2)
      return false;
    if (value < min || value > max) return false;
  }
  return true;
}

/// The smallest singular value of the Jacobian with lengths in units of the reach.
double far_from_singular(const ChainModel& model, const JointVector& joints, double reach) {
  Jacobian jacobian = model.jacobian(joints, Eigen::Vector3d::Zero());
  jacobian.topRows<3>() /= reach;
  return Eigen::JacobiSVD<Jacobian>(jacobian).singularValues().minCoeff();
}

/// Higher is better.
double score_of(const ChainModel& model, const JointVector& joints, double reach) {
  const Pose tool = model.flange(joints);
  const Eigen::Vector3d place = tool.translation() / reach;
  const double front = place.x() - std::abs(place.y());
  const double above = std::min(place.z(), 0.3);
  return far_from_singular(model, joints, reach) * 4 + 0.3 * front + above - 0.02 * joints.cwiseAbs().sum();
}

void add_down_poses(const ChainModel& model, const std::vector<AxisLimits>& axes, double reach,
                    std::vector<Candidate>& candidates) {
  const JointVector zero = JointVector::Zero(std::ssize(axes));
  for (const double distance : {0.4, 0.5, 0.6, 0.7}) {  // of the reach
    for (const double height : {0.1, 0.2, 0.3, 0.45}) {
      for (int turn = 0; turn < 4; ++turn) {
        const Pose pose =
            pose_from_rpy({distance * reach, 0, height * reach}, {std::numbers::pi, 0, turn * std::numbers::pi / 2});
        Collected collected;
        model.branches(pose, zero, collected);
        for (const JointVector& joints : collected.postures)
          if (in_the_middle(joints, axes)) candidates.push_back({joints, kDownFirst + score_of(model, joints, reach)});
      }
    }
  }
}

}  // namespace

ChainModel chain_model_of(const UrdfArm& arm, const std::vector<AxisLimits>& axes) {
  RobotParameters parameters;
  for (const AxisLimits& limits : axes) {
    AxisParameters axis;
    axis.name = limits.name;
    axis.position_min = limits.position_min.value;
    axis.position_max = limits.position_max.value;
    parameters.axes.push_back(axis);
  }
  return {"nominal", parameters, arm.chain, JointVector::Ones(std::ssize(axes))};
}

JointVector find_home(const ChainModel& model, const std::vector<AxisLimits>& axes, const MayBeHome& may_be) {
  std::mt19937_64 random(kHomeSeed);
  std::vector<JointVector> postures;
  double reach = 1e-3;
  for (int i = 0; i < kPostures; ++i) {
    postures.push_back(random_posture(axes, random));
    reach = std::max(reach, model.flange(postures.back()).translation().norm());
  }
  std::vector<Candidate> candidates;
  for (const JointVector& joints : postures)
    if (in_the_middle(joints, axes)) candidates.push_back({joints, score_of(model, joints, reach)});
  if (axes.size() >= 6) add_down_poses(model, axes, reach, candidates);
  if (candidates.empty()) candidates.push_back({postures.front(), 0});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  const std::size_t asked = std::min<std::size_t>(candidates.size(), kAsked);
  for (Candidate& candidate : std::span(candidates).first(asked)) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      double& value = candidate.joints[static_cast<Eigen::Index>(i)];
      const double rounded = std::round(value * kRound) / kRound;
      if (rounded >= axes[i].position_min.value && rounded <= axes[i].position_max.value) value = rounded;
    }
    if (may_be(candidate.joints)) return candidate.joints;
  }
  return candidates.front().joints;
}

}  // namespace mrroc::cli
