#include "language/cooperation/object_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/require.hpp"
#include "geometry/near_places.hpp"
#include "geometry/pose_path.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/errors.hpp"

namespace mrroc {

namespace {

constexpr double kObjectJerkRate = 10;         // 1/s: jerk per acceleration
constexpr double kMostTurn = 3;                // rad: at pi the rotation vector is not unique
constexpr double kEqual = 1e-9;                // m, rad
constexpr int kKnotSamples = 64;               // between two knots, to find the largest derivatives
constexpr double kMargin = 0.98;               // what lies between the samples
constexpr double kParameterDifference = 1e-4;  // s of the parameter

[[noreturn]] void refuse(const std::string& what) {
  throw NonFatalError(ErrorCode::invalid_argument, "path of an object: " + what);
}

}  // namespace

ObjectPath::ObjectPath(const std::vector<Pose>& poses, const CooperativeLimits& limits) {
  const char* const name = "path of an object";
  require_above_zero(name, "speed", limits.speed);
  require_above_zero(name, "acceleration", limits.acceleration);
  require_above_zero(name, "angular speed", limits.angular_speed);
  require_above_zero(name, "angular acceleration", limits.angular_acceleration);
  if (poses.empty()) refuse("no pose");
  const auto near = [&poses](std::size_t a, std::size_t b) { return are_near(poses[a], poses[b]); };
  const std::vector<std::size_t> kept = distinct_places(poses.size() - 1, near);
  std::size_t last = 0;  // of the kept ones
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::string number = "pose " + std::to_string(i + 1);
    if (!is_rigid(poses[i])) refuse(number + " is not rigid");
    if (i == 0) first_ = poses[0].linear();
    Coordinates x;
    x << poses[i].translation(), rotation_vector(first_.transpose() * poses[i].linear());
    if (x.tail<3>().norm() > kMostTurn) {
      refuse(number + " is rotated by " + std::to_string(x.tail<3>().norm()) +
             " rad from the first, expected at most 3");
    }
    const auto way_from = [&](std::size_t k) { return (poses[i].translation() - poses[k].translation()).norm(); };
    const auto turn_from = [&](std::size_t k) {
      return rotation_vector(poses[k].linear().transpose() * poses[i].linear()).norm();
    };
    if (i > 0 && way_from(i - 1) < kEqual && turn_from(i - 1) < kEqual) refuse(number + " equals the previous one");
    if (!std::binary_search(kept.begin(), kept.end(), i)) continue;
    double knot = 0;
    if (i > 0) knot = knots_.back() + std::max(way_from(last) / limits.speed, turn_from(last) / limits.angular_speed);
    last = i;
    knots_.push_back(knot);
    values_.push_back(x);
  }
  interpolate();
  if (knots_.size() > 1) choose_speed(limits), plan(0);
}

/// The second derivatives of the natural cubic spline: a tridiagonal system (Thomas).
void ObjectPath::interpolate() {
  const std::size_t count = knots_.size();
  curvatures_.assign(count, Coordinates::Zero());
  std::vector<double> upper(count, 0.0);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double before = knots_[i] - knots_[i - 1], after = knots_[i + 1] - knots_[i];
    const Coordinates right = 6 * ((values_[i + 1] - values_[i]) / after - (values_[i] - values_[i - 1]) / before);
    const double diagonal = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / diagonal;
    curvatures_[i] = (right - before * curvatures_[i - 1]) / diagonal;
  }
  for (std::size_t i = count; i-- > 2;) curvatures_[i - 1] -= upper[i - 1] * curvatures_[i];
}

ObjectPath::Coordinates ObjectPath::coordinates(double u) const noexcept {
  if (knots_.size() == 1) return values_[0];
  const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, u);
  const auto i = static_cast<std::size_t>(next - knots_.begin());
  const double width = knots_[i] - knots_[i - 1], a = (knots_[i] - u) / width, b = 1 - a;
  return a * values_[i - 1] + b * values_[i] +
         (width * width / 6) * ((a * a * a - a) * curvatures_[i - 1] + (b * b * b - b) * curvatures_[i]);
}

Pose ObjectPath::pose(double u) const noexcept {
  const Coordinates x = coordinates(u);
  Pose pose = Pose::Identity();
  pose.translation() = x.head<3>();
  pose.linear() = first_ * exp_rotation(x.tail<3>());
  return pose;
}

void ObjectPath::choose_speed(const CooperativeLimits& limits) {
  // the largest first and second derivatives by u: of the position, of the rotation
  double way = 0, bend = 0, turn = 0, twist = 0;
  const double h = kParameterDifference;
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    for (int sample = 0; sample <= kKnotSamples; ++sample) {
      const double u = knots_[i - 1] + (knots_[i] - knots_[i - 1]) * sample / kKnotSamples;
      const Pose before = pose(u - h), there = pose(u), after = pose(u + h);
      way = std::max(way, (after.translation() - before.translation()).norm() / (2 * h));
      bend = std::max(bend, (after.translation() - 2 * there.translation() + before.translation()).norm() / (h * h));
      const Eigen::Vector3d first = rotation_vector(there.linear() * before.linear().transpose());
      const Eigen::Vector3d second = rotation_vector(after.linear() * there.linear().transpose());
      turn = std::max(turn, (first + second).norm() / (2 * h));
      twist = std::max(twist, (second - first).norm() / (h * h));
    }
  }
  // half of the acceleration for the curves, the remainder for gaining speed
  const double speed =
      kMargin * std::min({limits.speed / way, limits.angular_speed / turn, std::sqrt(0.5 * limits.acceleration / bend),
                          std::sqrt(0.5 * limits.angular_acceleration / twist)});
  input_.max_velocity[0] = speed;
  input_.max_acceleration[0] = kMargin * std::min((limits.acceleration - bend * speed * speed) / way,
                                                  (limits.angular_acceleration - twist * speed * speed) / turn);
  input_.max_jerk[0] = kObjectJerkRate * input_.max_acceleration[0];
}

void ObjectPath::plan(double from) {
  input_.current_position[0] = from;
  input_.target_position[0] = knots_.back();
  ruckig::Ruckig<1> ruckig;
  const ruckig::Result result = ruckig.calculate(input_, trajectory_);
  if (result != ruckig::Result::Working && result != ruckig::Result::Finished) {
    refuse("no speed along it (Ruckig result " + std::to_string(static_cast<int>(result)) + ")");
  }
}

double ObjectPath::parameter(double t) const noexcept {
  if (knots_.size() == 1) return 0;
  std::array<double, 1> u{}, speed{}, acceleration{};
  trajectory_.at_time(std::clamp(t, 0.0, trajectory_.get_duration()), u, speed, acceleration);
  return u[0];
}

void ObjectPath::stop(double t) noexcept {
  if (knots_.size() == 1) return;
  ruckig::InputParameter<1> input = input_;
  input.control_interface = ruckig::ControlInterface::Velocity;
  trajectory_.at_time(std::clamp(t, 0.0, trajectory_.get_duration()), input.current_position, input.current_velocity,
                      input.current_acceleration);
  ruckig::Ruckig<1> ruckig;
  ruckig.calculate(input, trajectory_);  // a trajectory to rest always exists
}

Pose ObjectPath::restart(double t, const Pose& pose, double ahead) {
  if (knots_.size() == 1) return this->pose(0);
  const double from = parameter(t), to = std::min(from + ahead * input_.max_velocity[0], knots_.back());
  double best = from, least = INFINITY;
  for (int sample = 0; sample <= kKnotSamples; ++sample) {
    const double u = from + (to - from) * sample / kKnotSamples;
    const Pose off = this->pose(u).inverse() * pose;
    const double distance = off.translation().squaredNorm() + rotation_vector(off.linear()).squaredNorm();
    if (distance < least) best = u, least = distance;
  }
  plan(best);
  return this->pose(best);
}

}  // namespace mrroc
