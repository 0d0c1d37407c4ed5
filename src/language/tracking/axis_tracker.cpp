#include "language/tracking/axis_tracker.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <ruckig/ruckig.hpp>

namespace mrroc {

namespace {

// parts of the bounds for the time-optimal motion: what its mean jerk leaves out is made up for with the rest
constexpr double kVelocityPart = 0.98, kAccelerationPart = 0.95, kJerkPart = 0.8;
constexpr int kParts = 8;
constexpr double kLonger = 1.12;    // than the shortest time: with these parts it takes 1.08 of it
constexpr int kSlack = 2;           // periods that a landing may take longer than the shortest time
constexpr double kRounding = 1e-9;  // relative to the motion of one period at the bounds

/// What a jerk of 1 in one period contributes `behind` periods later, to p / T^3, v / T^2 and a / T.
Eigen::Vector3d effect(int behind) {
  const double m = behind;
  return {m * m / 2 + m / 2 + 1.0 / 6, m + 0.5, 1};
}

}  // namespace

/// Ruckig and the inverses of the least-norm problems, by number of periods.
struct AxisTracker::Online {
  mutable ruckig::Ruckig<1> ruckig;
  mutable ruckig::InputParameter<1> input;
  mutable ruckig::Trajectory<1> trajectory;
  std::array<Eigen::Matrix3d, kMost + 1> inverse;

  Online() {
    for (int periods = 3; periods <= kMost; ++periods) {
      Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
      for (int behind = 0; behind < periods; ++behind) gram += effect(behind) * effect(behind).transpose();
      inverse[static_cast<std::size_t>(periods)] = gram.inverse();
    }
    input.target_position[0] = input.target_velocity[0] = input.target_acceleration[0] = 0;
  }
};

AxisTracker::AxisTracker(double step) : step_(step), online_(std::make_unique<Online>()) {}
AxisTracker::~AxisTracker() = default;
AxisTracker::AxisTracker(AxisTracker&&) noexcept = default;

AxisMotion AxisTracker::after(const AxisMotion& from, double jerk) const noexcept {
  const double t = step_;
  return {from.position + t * (from.velocity + t * (from.acceleration / 2 + t * jerk / 6)),
          from.velocity + t * (from.acceleration + t * jerk / 2), from.acceleration + t * jerk};
}

/// Fewer than three jerks solve three equations only if they have been part of a longer solution: `lands` finds out.
void AxisTracker::solve(const AxisMotion& from, int periods, Jerks& jerks) const noexcept {
  const double t = step_, n = periods;
  const Eigen::Vector3d missing =
      -Eigen::Vector3d((from.position + n * t * (from.velocity + n * t * from.acceleration / 2)) / (t * t * t),
                       (from.velocity + n * t * from.acceleration) / (t * t), from.acceleration / t);
  if (periods == 1) {
    jerks[0] = missing[2];
    return;
  }
  if (periods == 2) {  // effect(1) and effect(0) on v and a
    jerks[0] = missing[1] - 0.5 * missing[2];
    jerks[1] = missing[2] - jerks[0];
    return;
  }
  const Eigen::Vector3d weights = online_->inverse[static_cast<std::size_t>(periods)] * missing;
  for (int i = 0; i < periods; ++i) jerks[static_cast<std::size_t>(i)] = effect(periods - 1 - i).dot(weights);
}

bool AxisTracker::lands(const AxisMotion& from, const AxisBounds& bounds, int periods, Jerks& jerks) const noexcept {
  solve(from, periods, jerks);
  const double side = from.position < 0 ? -1 : 1, t = step_;
  const AxisBounds small{kRounding * bounds.velocity, kRounding * bounds.acceleration, kRounding * bounds.jerk};
  const double near = kRounding * bounds.jerk * t * t * t + 1e-12 * (1 + std::abs(from.position));
  AxisMotion motion = from;
  for (int i = 0; i < periods; ++i) {
    const double jerk = jerks[static_cast<std::size_t>(i)];
    if (!(std::abs(jerk) <= bounds.jerk + small.jerk)) return false;
    const double turn = jerk == 0 ? -1 : -motion.acceleration / jerk;  // where the velocity is extreme
    if (turn > 0 && turn < t &&
        std::abs(motion.velocity + turn * motion.acceleration / 2) > bounds.velocity + small.velocity)
      return false;
    motion = after(motion, jerk);
    if (std::abs(motion.acceleration) > bounds.acceleration + small.acceleration ||
        std::abs(motion.velocity) > bounds.velocity + small.velocity || side * motion.position < -near)
      return false;
  }
  return std::abs(motion.position) <= near && std::abs(motion.velocity) <= 1e3 * near / t &&
         std::abs(motion.acceleration) <= 1e6 * near / (t * t);
}

double AxisTracker::jerk(const AxisMotion& from, const AxisBounds& bounds) const noexcept {
  Jerks jerks{};
  const double shortest = plan(from, bounds) ? online_->trajectory.get_duration() : 0;
  const int first = std::max(1, static_cast<int>(std::ceil(shortest / step_ - kRounding)));
  for (int count = first; count <= std::min(kMost, first + kSlack); ++count)
    if (lands(from, bounds, count, jerks)) return jerks[0];
  std::array<double, 1> p{}, v{}, a{};
  if (plan_with_reserve(from, bounds, kLonger * shortest + step_)) online_->trajectory.at_time(step_, p, v, a);
  // the end of the period within the velocity limit
  const auto to_velocity = [&](double v1) {
    return 2 * (v1 - from.velocity - from.acceleration * step_) / (step_ * step_);
  };
  const double least = std::max(-bounds.jerk, to_velocity(-bounds.velocity));
  const double most = std::min(bounds.jerk, to_velocity(bounds.velocity));
  const double mean = (a[0] - from.acceleration) / step_;
  return least <= most ? std::clamp(mean, least, most) : std::clamp(mean, -bounds.jerk, bounds.jerk);
}

/// With the smallest of some parts of the bounds that lead to the target without passing it or turning back before it.
bool AxisTracker::plan_with_reserve(const AxisMotion& from, const AxisBounds& bounds, double longest) const noexcept {
  bool planned = false;
  for (int i = 0; i <= kParts; ++i) {
    const auto part = [i](double least) { return least + (1 - least) * i / kParts; };
    planned = plan(from, {kVelocityPart * bounds.velocity, part(kAccelerationPart) * bounds.acceleration,
                          part(kJerkPart) * bounds.jerk});
    if (planned && online_->trajectory.get_duration() <= longest && !passes_target(from)) break;
  }
  return planned;
}

bool AxisTracker::passes_target(const AxisMotion& from) const noexcept {
  std::array<ruckig::Bound, 1> found{};
  online_->trajectory.get_position_extrema(found);
  const ruckig::Bound& extrema = found[0];
  return from.position < 0 ? extrema.max > kRounding : extrema.min < -kRounding;
}

bool AxisTracker::plan(const AxisMotion& from, const AxisBounds& bounds) const noexcept {
  auto& input = online_->input;
  input.current_position[0] = from.position;
  input.current_velocity[0] = from.velocity;
  input.current_acceleration[0] = from.acceleration;
  input.max_velocity[0] = bounds.velocity;
  input.max_acceleration[0] = bounds.acceleration;
  input.max_jerk[0] = bounds.jerk;
  const ruckig::Result result = online_->ruckig.calculate(input, online_->trajectory);
  return result == ruckig::Result::Working || result == ruckig::Result::Finished;
}

}  // namespace mrroc
