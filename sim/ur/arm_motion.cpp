#include "sim/ur/arm_motion.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::sim::ur {
namespace {

constexpr double kReached = 1e-4, kAtRest = 1e-3;  // rad, rad/s

/// `from` changed towards `to` by at most `step`.
double approach(double from, double to, double step) { return from + std::clamp(to - from, -step, step); }

}  // namespace

void ArmMotion::servoj(const Six& position) {
  stopping_ = moving_ = false;
  now_ = {JointTargets::Kind::position, position, {}};
  commanded_ = true;
}

void ArmMotion::speedj(const Six& velocity, double acceleration) {
  stopping_ = moving_ = false;
  if (now_.kind != JointTargets::Kind::velocity) now_ = {JointTargets::Kind::velocity, {}, {}};
  for (std::size_t i = 0; i < velocity.size(); ++i)
    now_.velocity[i] = approach(now_.velocity[i], velocity[i], acceleration * period_);
  commanded_ = true;
}

void ArmMotion::stopj(double deceleration, const JointPlant& plant) {
  moving_ = false;
  stopping_ = true;
  deceleration_ = deceleration;
  now_ = {JointTargets::Kind::velocity, {}, plant.velocity()};
}

void ArmMotion::movej(const Six& to, double speed, double acceleration, const JointPlant& plant) {
  stopping_ = false;
  moving_ = true;
  from_ = plant.position();
  to_ = to;
  speed_ = speed;
  acceleration_ = acceleration;
  path_ = path_speed_ = distance_ = 0;
  for (std::size_t i = 0; i < to.size(); ++i) distance_ = std::max(distance_, std::abs(to[i] - from_[i]));
}

void ArmMotion::cancel() noexcept {
  stopping_ = moving_ = commanded_ = false;
  now_ = {};
}

JointTargets ArmMotion::targets(const JointPlant& plant) {
  if (moving_) return now_ = continue_move(plant);
  if (stopping_) return now_ = continue_stop(plant);
  if (!commanded_) {
    // the position of the first period without a command
    if (now_.kind != JointTargets::Kind::position) now_ = {JointTargets::Kind::position, plant.position(), {}};
  }
  commanded_ = false;
  return now_;
}

/// A trapezoid of the speed of the joint with the longest way; the others move in proportion.
JointTargets ArmMotion::continue_move(const JointPlant& plant) {
  const double rest = distance_ - path_;
  const double braking = std::sqrt(2 * acceleration_ * std::max(rest, 0.0));
  path_speed_ = std::min({path_speed_ + acceleration_ * period_, speed_, braking});
  path_ = std::min(path_ + path_speed_ * period_, distance_);
  if (distance_ - path_ < kReached) path_ = distance_;
  JointTargets targets{JointTargets::Kind::position, to_, {}};
  if (path_ < distance_)
    for (std::size_t i = 0; i < to_.size(); ++i)
      targets.position[i] = from_[i] + (to_[i] - from_[i]) * path_ / distance_;
  double error = 0, rate = 0;
  for (std::size_t i = 0; i < to_.size(); ++i) {
    error = std::max(error, std::abs(plant.position()[i] - to_[i]));
    rate = std::max(rate, std::abs(plant.velocity()[i]));
  }
  moving_ = error > kReached || rate > kAtRest;
  return targets;
}

/// Until the joints are at rest, not only their targets.
JointTargets ArmMotion::continue_stop(const JointPlant& plant) {
  JointTargets targets = now_;
  const Six rates = plant.velocity();
  stopping_ = std::any_of(rates.begin(), rates.end(), [](double rate) { return std::abs(rate) > kAtRest; });
  for (double& rate : targets.velocity) {
    rate = approach(rate, 0, deceleration_ * period_);
    stopping_ = stopping_ || rate != 0;
  }
  return targets;
}

}  // namespace mrroc::sim::ur
