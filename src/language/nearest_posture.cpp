#include "language/nearest_posture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "language/limits.hpp"
#include "language/rigid_motion.hpp"

namespace mrroc {
namespace {

constexpr double kExact = 1e-9;  // m, rad: a pose that differs by less is the same
constexpr int kTurns = 8;        // of an axis, tried beyond the nearest one

/// Motor that passes its limit: -1 none, else its number; `joint_count` when the transmission cannot reach the joints.
int motor_beyond(const RobotModel& model, const JointVector& joints, double& value) noexcept {
  JointVector motors;
  if (model.joints_to_motors(joints, motors) != ErrorCode::none) return model.joint_count();
  for (int i = 0; i < model.joint_count(); ++i) {
    const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
    if (is_within(motors[i], axis.motor_min, axis.motor_max)) continue;
    value = motors[i];
    return i;
  }
  return -1;
}

class Choice final : public BranchReceiver {
 public:
  Choice(const ToolKinematics& kinematics, const Pose& pose, const JointVector& near) noexcept
      : kinematics_(kinematics), pose_(pose), near_(near) {
    posture_.code = ErrorCode::out_of_workspace;
    for (int i = 0; i < model().joint_count(); ++i) periods_[static_cast<std::size_t>(i)] = model().joint_period(i);
  }

  void add(const JointVector& joints, bool exact) noexcept override {
    if (joints.size() != model().joint_count() || !joints.allFinite()) return;
    JointVector turned = joints;
    int beyond = -1;
    bool slightly = true;
    for (int i = 0; i < joints.size(); ++i) {
      const AxisParameters& axis = model().parameters().axes[static_cast<std::size_t>(i)];
      const auto k = static_cast<std::size_t>(i);
      const double period = periods_[k];
      const bool turned_best = joints[i] >= axis.position_min && joints[i] <= axis.position_max &&
                               std::abs(near_[i] - joints[i]) <= period / 2;
      if (period > 0 && !turned_best) turned[i] += nearest_turn(axis, joints[i], near_[i], period) * period;
      const double inside = std::clamp(turned[i], axis.position_min, axis.position_max);
      if (!is_within(turned[i], axis.position_min, axis.position_max)) {
        if (std::abs(inside - turned[i]) > kRotationTolerance) slightly = false;
        if (beyond < 0) beyond = i;
      } else {
        turned[i] = inside;
      }
    }
    if (beyond < 0) return choose_turns(turned, 0, exact);
    if (!found_ && distance(turned) < refused_) refuse(turned, ErrorCode::joint_limit, beyond, turned[beyond]);
    if (slightly) {
      for (int i = 0; i < joints.size(); ++i) {
        const AxisParameters& axis = model().parameters().axes[static_cast<std::size_t>(i)];
        turned[i] = std::clamp(turned[i], axis.position_min, axis.position_max);
      }
      consider(turned, false);
    }
  }

  bool found() const noexcept override { return found_; }

  const Posture& posture() const noexcept { return found_ || !projected_ ? posture_ : near_miss_; }

 private:
  const RobotModel& model() const noexcept { return kinematics_.model(); }

  double distance(const JointVector& joints) const noexcept {
    double sum = 0;
    for (int i = 0; i < joints.size(); ++i) {
      const double change =
          (joints[i] - near_[i]) / model().parameters().axes[static_cast<std::size_t>(i)].velocity_max;
      sum += change * change;
    }
    return sum;
  }

  static double nearest_turn(const AxisParameters& axis, double joint, double near, double period) noexcept {
    const double tolerance = position_tolerance(axis.position_min, axis.position_max);
    const double low = std::ceil((axis.position_min - tolerance - joint) / period);
    const double high = std::floor((axis.position_max + tolerance - joint) / period);
    const double wanted = std::round((near - joint) / period);
    return low <= high ? std::clamp(wanted, low, high) : wanted;
  }

  /// `joints`, the nearest turn of each, or where the motors cannot go there other turns of the joints from `from` on.
  void choose_turns(const JointVector& joints, int from, bool exact) noexcept {
    consider(joints, exact);
    if (reached_) return;  // every other turn is farther
    for (int i = from; i < joints.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const AxisParameters& axis = model().parameters().axes[k];
      // an axis without limits has none of the motor either, as a rule: its nearest turn is enough
      if (periods_[k] == 0 || !std::isfinite(axis.position_max - axis.position_min)) continue;
      for (int turns = -kTurns; turns <= kTurns; ++turns) {
        JointVector other = joints;
        other[i] += turns * periods_[k];
        if (turns != 0 && other[i] >= axis.position_min && other[i] <= axis.position_max)
          choose_turns(other, i + 1, exact);
      }
    }
  }

  /// Within the joint limits; the motors' are to be looked at.
  void consider(const JointVector& joints, bool exact) noexcept {
    reached_ = false;
    const double square = distance(joints);
    if (found_ && square >= best_) {
      reached_ = true;
      return;
    }
    double value = 0;
    if (const int motor = motor_beyond(model(), joints, value); motor >= 0) {
      if (!found_ && square < refused_)
        refuse(joints, ErrorCode::motor_limit, motor < model().joint_count() ? motor : -1, value);
      return;
    }
    PoseDeviation off;
    if (!exact) {
      off = deviation(kinematics_.direct(joints), pose_);
      const bool tolerable = off.position <= kPositionTolerance && off.rotation <= kRotationTolerance;
      const bool same = off.position <= kExact && off.rotation <= kExact;
      if (!same) {
        const double error = off.position / kPositionTolerance + off.rotation / kRotationTolerance;
        if (error < miss_ && (tolerable || refused_ == kFar)) {
          miss_ = error;
          projected_ = true;
          near_miss_ = {joints, off, tolerable ? ErrorCode::none : ErrorCode::out_of_workspace};
        }
        return;
      }
    }
    found_ = reached_ = true;
    best_ = square;
    posture_ = {joints, off};
  }

  void refuse(const JointVector& joints, ErrorCode code, int axis, double value) noexcept {
    refused_ = distance(joints);
    posture_ = {joints, {}, code, axis, value};
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();

  const ToolKinematics& kinematics_;
  const Pose& pose_;
  const JointVector& near_;
  std::array<double, kMaxJoints> periods_{};
  Posture posture_, near_miss_;
  double best_ = kFar, refused_ = kFar, miss_ = kFar;
  bool found_ = false, projected_ = false, reached_ = false;
};

}  // namespace

PoseDeviation deviation(const Pose& from, const Pose& to) noexcept {
  return {(to.translation() - from.translation()).norm(),
          rotation_vector(Eigen::Matrix3d(from.linear().transpose() * to.linear())).norm()};
}

bool within_limits(const RobotModel& model, const JointVector& joints) noexcept {
  for (int i = 0; i < model.joint_count(); ++i) {
    const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
    if (!is_within(joints[i], axis.position_min, axis.position_max)) return false;
  }
  double value = 0;
  return motor_beyond(model, joints, value) < 0;
}

Posture nearest_posture(const ToolKinematics& kinematics, const Pose& pose, const JointVector& near) noexcept {
  Choice choice(kinematics, pose, near);
  kinematics.branches(pose, near, choice);
  return choice.posture();
}

ErrorCode ToolKinematics::inverse(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept {
  const ErrorCode code = follow(pose, near, joints);
  if (code == ErrorCode::none && within_limits(*model_, joints)) return code;
  if (!near.allFinite() || near.size() != model_->joint_count()) return code;
  Posture posture = nearest_posture(*this, pose, near);
  if (posture.code != ErrorCode::none) return code;
  joints = posture.joints;
  return code == ErrorCode::singular ? code : ErrorCode::none;
}

}  // namespace mrroc
