#include "language/joints/joint_spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/knot_rates.hpp"
#include "geometry/near_places.hpp"
#include "language/joints/joint_targets.hpp"

namespace mrroc {

namespace {

constexpr double kSame = 1e-9;       // s at full speed
constexpr double kMostSlope = 1.25;  // of a calmed joint
constexpr int kHalvings = 6;         // of a piece, to bound its range
constexpr double kSplineRounding = 1e-12;

double full_speed_time(const RobotParameters& parameters, const JointVector& from, const JointVector& to) {
  double longest = 0;
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    longest = std::max(longest, std::abs(to[row] - from[row]) / parameters.axes[i].velocity_max);
  }
  return longest;
}

/// A polynomial of degree five on 0..1 in Bernstein's form: it stays between its least and its greatest coefficient.
using Bernstein = std::array<double, 6>;

Bernstein bernstein(const QuinticPiece<Eigen::Dynamic, kMaxJoints>::State& from,
                    const QuinticPiece<Eigen::Dynamic, kMaxJoints>::State& to, Eigen::Index row, double length) {
  const double a = from.value[row], b = to.value[row], first = length / 5, second = length * length / 20;
  return {a,
          a + first * from.first[row],
          a + 2 * first * from.first[row] + second * from.second[row],
          b - 2 * first * to.first[row] + second * to.second[row],
          b - first * to.first[row],
          b};
}

/// False also when some halvings (de Casteljau) cannot prove it: a curve that touches a bound, possibly from outside.
bool stays_within(Bernstein left, double low, double high, int halvings) {
  const auto [least, greatest] = std::minmax_element(left.begin(), left.end());
  if (*least >= low && *greatest <= high) return true;
  if (halvings == 0 || std::min(left.front(), left.back()) < low || std::max(left.front(), left.back()) > high)
    return false;
  Bernstein right = left;
  for (std::size_t level = 1; level < left.size(); ++level) {
    for (std::size_t i = 0; i + level < right.size(); ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
    left[level] = right[0];
  }
  return stays_within(left, low, high, halvings - 1) && stays_within(right, low, high, halvings - 1);
}

}  // namespace

JointSpline::JointSpline(const RobotParameters& parameters, const std::vector<JointVector>& waypoints, double speed,
                         double step) {
  const JointVector none = JointVector::Zero(waypoints.front().size());
  const auto near = [&waypoints](std::size_t a, std::size_t b) {
    return (waypoints[a] - waypoints[b]).lpNorm<Eigen::Infinity>() < kSamePlace;
  };
  for (const std::size_t place : distinct_places(waypoints.size() - 1, near)) {
    const JointVector& waypoint = waypoints[place];
    if (!knots_.empty()) {
      const double time = full_speed_time(parameters, knots_.back().value, waypoint);
      if (time < kSame) continue;
      breaks_.push_back(breaks_.back() + time);
    }
    knots_.push_back({waypoint, none, none});
  }
  waypoints_ = breaks_;
  if (breaks_.size() > 1) {
    stops_.push_back(breaks_.back());
    keep_off_limits(parameters, step);
    plan();
    build();
    while (calm(parameters)) build();
  }
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const AxisParameters& axis = parameters.axes[i];
    limits_.push_back({kJointRow + static_cast<int>(i), 1, kVelocityShare * axis.velocity_max * speed,
                       kAccelerationShare * axis.acceleration_max * speed * speed,
                       kJerkShare * axis.jerk_max * speed * speed * speed});
  }
}

void JointSpline::keep_off_limits(const RobotParameters& parameters, double step) {
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const AxisParameters& axis = parameters.axes[i];
    const double middle = 0.5 * (axis.position_min + axis.position_max);
    const double off = kJerkShare * axis.jerk_max * step * step * step / 192;
    const double low = std::min(axis.position_min + off, middle), high = std::max(axis.position_max - off, middle);
    for (std::size_t k = 1; k + 1 < knots_.size(); ++k) {
      double& position = knots_[k].value[static_cast<Eigen::Index>(i)];
      position = std::clamp(position, low, high);
    }
  }
}

void JointSpline::plan() {
  Eigen::MatrixXd values(knots_.size(), knots_.front().value.size());
  for (std::size_t i = 0; i < knots_.size(); ++i) values.row(static_cast<Eigen::Index>(i)) = knots_[i].value;
  const KnotRates rates = knot_rates(SplineOrder::cubic, SplineEnds::straight, breaks_, values);
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    knots_[i].first = rates.first.row(static_cast<Eigen::Index>(i));
    knots_[i].second = rates.second.row(static_cast<Eigen::Index>(i));
  }
}

void JointSpline::build() {
  pieces_.clear();
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i)
    pieces_.emplace_back(knots_[i], knots_[i + 1], breaks_[i + 1] - breaks_[i]);
}

bool JointSpline::calm(const RobotParameters& parameters) {
  bool changed = false;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    for (std::size_t k = 0; k < parameters.axes.size(); ++k) {
      const AxisParameters& axis = parameters.axes[k];
      const auto row = static_cast<Eigen::Index>(k);
      const auto [low, high] = std::minmax(knots_[i].value[row], knots_[i + 1].value[row]);
      const double room = std::pow(axis.acceleration_max, 3) / std::pow(axis.jerk_max, 2);
      const double lowest = std::min(low, axis.position_min + room) - kSplineRounding;
      const double highest = std::max(high, axis.position_max - room) + kSplineRounding;
      const double h = pieces_[i].length();
      if (stays_within(bernstein(knots_[i], knots_[i + 1], row, h), lowest, highest, kHalvings)) continue;
      changed = calm_at(i, row) || changed;
      changed = calm_at(i + 1, row) || changed;
    }
  }
  return changed;
}

bool JointSpline::calm_at(std::size_t knot, Eigen::Index joint) {
  const auto slope = [&](std::size_t piece) {
    return (knots_[piece + 1].value[joint] - knots_[piece].value[joint]) / (breaks_[piece + 1] - breaks_[piece]);
  };
  const double before = slope(knot > 0 ? knot - 1 : 0), after = slope(std::min(knot, knots_.size() - 2));
  const double most = before * after > 0 ? kMostSlope * std::min(std::abs(before), std::abs(after)) : 0;
  double& first = knots_[knot].first[joint];
  double& second = knots_[knot].second[joint];
  const double calmed = first * after > 0 ? std::copysign(std::min(std::abs(first), most), after) : 0;
  if (first == calmed && second == 0) return false;
  first = calmed;
  second = 0;
  return true;
}

PathRates JointSpline::rates(std::size_t piece, double s) const noexcept {
  const double local = s - breaks_[piece];
  const Piece::State state = pieces_[piece].at(local);
  PathRates rates;
  rates.first.segment(kJointRow, state.first.size()) = state.first;
  rates.second.segment(kJointRow, state.first.size()) = state.second;
  rates.third.segment(kJointRow, state.first.size()) = pieces_[piece].third(local);
  return rates;
}

JointVector JointSpline::joints(double s) const noexcept {
  if (s <= 0) return knots_.front().value;
  if (s >= length()) return knots_.back().value;
  const std::size_t piece = piece_at(s);
  return pieces_[piece].at(s - breaks_[piece]).value;
}

void JointSpline::command(double s, double speed, double acceleration, RobotCommand& command) const noexcept {
  command.kind = CommandKind::joint;
  command.joints = joints(s);
  if (speed == 0 && acceleration == 0) return;  // at rest
  const std::size_t piece = piece_at(s);
  const Piece::State state = pieces_[piece].at(s - breaks_[piece]);
  command.joint_velocity = speed * state.first;
  command.joint_acceleration = acceleration * state.first + (speed * speed) * state.second;
}

}  // namespace mrroc
