#include "language/joints/nearest_posture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/rigid_motion.hpp"
#include "language/limits.hpp"

namespace mrroc {
namespace {

constexpr double kExact = 1e-9;  // m, rad: a pose that differs by less is the same
constexpr int kTurns = 8;        // of an axis, tried beyond the nearest one

/// Motor that exceeds its limit: -1 no motor, else its number; `joint_count` when the transmission cannot reach the
/// joints.
int motor_beyond(const RobotModel& model, const JointVector& joints, double& value) noexcept {
  JointVector motors;
  const auto& axes = model.parameters().axes;
  const int count = static_cast<int>(axes.size());
  if (model.joints_to_motors(joints, motors) != ErrorCode::none) return count;
  for (int i = 0; i < count; ++i) {
    const AxisParameters& axis = axes[static_cast<std::size_t>(i)];
    if (is_within(motors[i], axis.motor_min, axis.motor_max)) continue;
    value = motors[i];
    return i;
  }
  return -1;
}

/// Collects the branches and checks them from the nearest on: motors and tool poses of as few as necessary.
class Choice final : public BranchReceiver {
 public:
  Choice(const ToolKinematics& kinematics, const Pose& pose, const JointVector& near) noexcept
      : kinematics_(kinematics),
        model_(kinematics.model()),
        pose_(pose),
        near_(near),
        axes_(model_.parameters().axes.data()),
        count_(model_.joint_count()) {
    miss_.code = refusal_.code = ErrorCode::out_of_workspace;
    for (int i = 0; i < count_; ++i) periods_[static_cast<std::size_t>(i)] = model_.joint_period(i);
  }

  void add(const JointVector& joints, bool exact) noexcept override {
    if (joints.size() != count_ || !joints.allFinite()) return;
    if (waiting_ == kWaiting) judge();
    Candidate& candidate = candidates_[waiting_];
    JointVector& turned = candidate.joints;
    turned = joints;
    int beyond = -1;
    bool slightly = true;
    for (int i = 0; i < joints.size(); ++i) {
      const AxisParameters& axis = axis_of(i);
      const double period = periods_[static_cast<std::size_t>(i)];
      const bool turned_best = joints[i] >= axis.position_min && joints[i] <= axis.position_max &&
                               std::abs(near_[i] - joints[i]) <= period / 2;
      if (period > 0 && !turned_best) turned[i] += nearest_turn(axis, joints[i], near_[i], period) * period;
      const double inside = std::clamp(turned[i], axis.position_min, axis.position_max);
      if (is_within(turned[i], axis.position_min, axis.position_max)) {
        turned[i] = inside;
      } else {
        if (std::abs(inside - turned[i]) > kRotationTolerance) slightly = false;
        if (beyond < 0) beyond = i;
      }
    }
    if (beyond >= 0) {
      refuse(turned, distance(turned), ErrorCode::joint_limit, beyond, turned[beyond]);
      if (!slightly) return;
      for (int i = 0; i < joints.size(); ++i) {
        turned[i] = std::clamp(turned[i], axis_of(i).position_min, axis_of(i).position_max);
      }
      exact = false;
    }
    ++waiting_;
    candidate.square = distance(turned);
    candidate.exact = exact;
    candidate.may_turn = beyond < 0;
  }

  bool found() noexcept override {
    judge();
    return best_ < kFar;
  }

  Posture posture() noexcept {
    if (found()) return posture_;
    return error_ < kFar && (miss_.code == ErrorCode::none || refused_ == kFar) ? miss_ : refusal_;
  }

 private:
  struct Candidate {
    JointVector joints;
    double square = 0;
    bool exact = false;
    bool may_turn = false;  // other turns of its joints also belong to its branch
  };

  const AxisParameters& axis_of(int i) const noexcept { return axes_[i]; }

  double distance(const JointVector& joints) const noexcept {
    double sum = 0;
    for (int i = 0; i < joints.size(); ++i) {
      const double change = (joints[i] - near_[i]) / axis_of(i).velocity_max;
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

  /// Of equal ones the first is checked first.
  void judge() noexcept {
    for (std::size_t judged = 0; judged < waiting_; ++judged) {
      std::size_t next = kWaiting;
      for (std::size_t i = 0; i < waiting_; ++i) {
        if (candidates_[i].square < best_ && (next == kWaiting || candidates_[i].square < candidates_[next].square))
          next = i;
      }
      if (next == kWaiting) break;
      const Candidate& candidate = candidates_[next];
      if (!is_taken(candidate.joints, candidate.square, candidate.exact) && candidate.may_turn) {
        choose_turns(candidate.joints, 0, candidate.exact);
      }
      candidates_[next].square = kFar;
    }
    waiting_ = 0;
  }

  /// Other turns of the joints from `from` on than those of `joints`, which are the nearest but not reachable by the
  /// motors.
  void choose_turns(const JointVector& joints, int from, bool exact) noexcept {
    for (int i = from; i < joints.size(); ++i) {
      const double period = periods_[static_cast<std::size_t>(i)];
      const AxisParameters& axis = axis_of(i);
      // an axis without limits usually has no motor limits either: its nearest turn is enough
      if (period == 0 || !std::isfinite(axis.position_max - axis.position_min)) continue;
      for (int turns = -kTurns; turns <= kTurns; ++turns) {
        JointVector other = joints;
        other[i] += turns * period;
        if (turns == 0 || other[i] < axis.position_min || other[i] > axis.position_max) continue;
        const double square = distance(other);
        if (square < best_ && !is_taken(other, square, exact)) choose_turns(other, i + 1, exact);
      }
    }
  }

  /// Whether `joints`, within the joint limits and nearer than the present result, become the posture.
  bool is_taken(const JointVector& joints, double square, bool exact) noexcept {
    double value = 0;
    if (const int motor = motor_beyond(model_, joints, value); motor >= 0) {
      refuse(joints, square, ErrorCode::motor_limit, motor < count_ ? motor : -1, value);
      return false;
    }
    PoseDeviation off;
    if (!exact) {
      off = deviation(kinematics_.direct(joints), pose_);
      if (off.position > kExact || off.rotation > kExact) {
        miss(joints, off);
        return false;
      }
    }
    best_ = square;
    posture_.joints = joints;
    posture_.deviation = off;
    return true;
  }

  void refuse(const JointVector& joints, double square, ErrorCode code, int axis, double value) noexcept {
    if (!(square < refused_)) return;
    refused_ = square;
    refusal_ = {joints, {}, code, axis, value};
  }

  /// A pose within the tolerances is preferred to all others.
  void miss(const JointVector& joints, const PoseDeviation& off) noexcept {
    const bool tolerable = off.position <= kPositionTolerance && off.rotation <= kRotationTolerance;
    const double error = off.position / kPositionTolerance + off.rotation / kRotationTolerance;
    const bool was_tolerable = miss_.code == ErrorCode::none;
    if (tolerable == was_tolerable ? error >= error_ : was_tolerable) return;
    error_ = error;
    miss_ = {joints, off, tolerable ? ErrorCode::none : ErrorCode::out_of_workspace};
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();
  static constexpr std::size_t kWaiting = 8;

  const ToolKinematics& kinematics_;
  const RobotModel& model_;
  const Pose& pose_;
  const JointVector& near_;
  const AxisParameters* axes_;
  int count_;
  std::array<double, kMaxJoints> periods_;
  std::array<Candidate, kWaiting> candidates_;
  std::size_t waiting_ = 0;
  Posture posture_, miss_, refusal_;
  double best_ = kFar, refused_ = kFar, error_ = kFar;  // distance^2 of them, error of `miss_`
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
