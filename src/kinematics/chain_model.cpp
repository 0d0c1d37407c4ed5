#include "kinematics/chain_model.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "kinematics/random_numbers.hpp"

namespace mrroc::kinematics {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSingular = 1e-6;                 // smallest singular value of the Jacobian, m/rad and rad/rad
constexpr double kBeside = 1.5;                    // rad or m, beside a posture that was found
constexpr double kEndless = 2 * std::numbers::pi;  // range in which a search looks where a joint has no limit

bool is_pose(const Pose& pose) noexcept {
  const Eigen::Matrix3d& r = pose.linear();
  return pose.matrix().allFinite() && (r * r.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-6;
}

}  // namespace

ChainModel::ChainModel(std::string name, RobotParameters parameters, const SerialChain& chain, const JointVector& gear)
    : name_(std::move(name)),
      parameters_(std::move(parameters)),
      chain_(chain),
      closed_form_(chain),
      similar_(chain, ClosedForm::kSimilar),
      gear_(gear) {
  const auto count = std::ssize(parameters_.axes);
  if (count != chain.size() || count != gear.size())
    throw std::invalid_argument(std::to_string(chain.size()) + " joints and " + std::to_string(gear.size()) +
                                " gears, expected " + std::to_string(count) + " of each");
  if ((gear.array() == 0).any() || !gear.allFinite()) throw std::invalid_argument("a gear that is zero or not finite");
  range_.min = range_.max = JointVector::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const AxisParameters& axis = parameters_.axes[static_cast<std::size_t>(i)];
    range_.min[i] = std::isfinite(axis.position_min) ? axis.position_min : -kEndless;
    range_.max[i] = std::isfinite(axis.position_max) ? axis.position_max : kEndless;
  }
}

ErrorCode ChainModel::motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept {
  joints = motors.cwiseQuotient(gear_);
  return ErrorCode::none;
}

ErrorCode ChainModel::joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept {
  motors = joints.cwiseProduct(gear_);
  return ErrorCode::none;
}

JointMatrix ChainModel::transmission(const JointVector&) const noexcept {
  JointMatrix matrix = JointMatrix::Zero(gear_.size(), gear_.size());
  matrix.diagonal() = gear_;
  return matrix;
}

double ChainModel::joint_period(int joint) const noexcept { return chain_.slides(joint) ? 0 : kTurn; }

void ChainModel::unwrap(const JointVector& near, JointVector& joints) const noexcept {
  for (int i = 0; i < joints.size(); ++i)
    if (!chain_.slides(i)) joints[i] += kTurn * std::round((near[i] - joints[i]) / kTurn);
}

ErrorCode ChainModel::inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  if (!is_pose(flange) || near.size() != chain_.size() || !near.allFinite()) return ErrorCode::out_of_workspace;
  return closed_form_ ? closed_inverse(flange, near, joints) : numeric_inverse(flange, near, joints);
}

ErrorCode ChainModel::closed_inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  ClosedForm::Postures postures;
  closed_form_.solve(flange, near, kTolerance, postures);
  double best = std::numeric_limits<double>::infinity();
  JointVector nearest;
  for (std::size_t i = 0; i < postures.count; ++i) {
    JointVector& posture = postures.joints[i];
    unwrap(near, posture);
    const double distance = (posture - near).cwiseAbs().sum();
    if (distance >= best) continue;
    best = distance;
    nearest = posture;
  }
  // a pose on the edge of the workspace, which rounding has moved beyond it
  if (postures.count == 0) return numeric_inverse(flange, near, joints);
  joints = nearest;
  return postures.singular && is_singular(joints) ? ErrorCode::singular : ErrorCode::none;
}

ErrorCode ChainModel::numeric_inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept {
  JointVector found = near;
  if (!improve(chain_, flange, kTolerance, kIterations, found)) return ErrorCode::out_of_workspace;
  unwrap(near, found);
  joints = found;
  return is_singular(joints) ? ErrorCode::singular : ErrorCode::none;
}

bool ChainModel::is_singular(const JointVector& joints) const noexcept {
  const Jacobian jacobian = chain_.jacobian(joints, Eigen::Vector3d::Zero());
  Eigen::JacobiSVD<Jacobian> svd(jacobian);
  return svd.singularValues().minCoeff() < kSingular;
}

void ChainModel::branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept {
  JointVector first = near;
  const ErrorCode code = inverse(flange, near, first);
  if (code == ErrorCode::none || code == ErrorCode::singular) receiver.add(first, true);
  if (!is_pose(flange) || near.size() != chain_.size() || !near.allFinite()) return;
  ClosedForm::Postures postures;
  (closed_form_ ? closed_form_ : similar_).solve(flange, near, kTolerance, postures);
  for (std::size_t i = 0; i < postures.count; ++i) {
    unwrap(near, postures.joints[i]);
    if (postures.joints[i] != first) receiver.add(postures.joints[i], true);
  }
  if (!closed_form_) search(flange, near, receiver);
}

void ChainModel::search(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept {
  std::uint64_t state = 1;
  JointVector last;  // near a singularity two branches lie side by side: every other search begins beside the last one
  for (int i = 0; i < kSearches && !receiver.found(); ++i) {
    const bool beside = i % 2 == 1 && last.size() > 0;
    JointVector posture(chain_.size());
    for (int j = 0; j < chain_.size(); ++j) {
      const double part = next_uniform(state);
      posture[j] = beside ? std::clamp(last[j] + (2 * part - 1) * kBeside, range_.min[j], range_.max[j])
                          : range_.min[j] + part * (range_.max[j] - range_.min[j]);
    }
    // the way to some branches leads through a limit
    const JointRange* const range = i % 4 < 2 ? &range_ : nullptr;
    if (!improve(chain_, flange, kTolerance, kSearchIterations, posture, range)) continue;
    if (range == nullptr) unwrap(near, posture);
    receiver.add(posture, true);
    last = posture;
  }
}

}  // namespace mrroc::kinematics
