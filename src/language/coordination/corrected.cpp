#include "mrroc/generators/corrected.hpp"

#include "core/require.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/coordination/displacement.hpp"
#include "language/force/force_step.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kGain = 2;    // 1/s
constexpr double kLag = 0.08;  // s
constexpr double kPart = 0.5;  // of the acceleration for braking: it is reached only after some time

Eigen::Vector3d at_most(const Eigen::Vector3d& vector, double most) {
  const double norm = vector.norm();
  return norm > most ? Eigen::Vector3d(vector * (most / norm)) : vector;
}

/// The velocity at which the way that remains is gone.
Eigen::Vector3d towards(const Eigen::Vector3d& way, double speed, double acceleration) {
  const double remaining = way.norm();
  if (remaining == 0) return way;
  return way * (approach_speed(remaining, speed, kPart * acceleration, kGain) / remaining);
}

}  // namespace

struct Corrected::Law {
  Robot& robot;
  Correction correction;
  CorrectionLimits limits;
  Displacement displacement;
  bool saturated = false;
};

Corrected::Corrected(Superior& superior, Robot& robot, Correction correction, const CorrectionLimits& limits)
    : Coordinated("Corrected", superior), law_(new Law{robot, std::move(correction), limits, {}}) {
  if (!law_->correction) throw NonFatalError(ErrorCode::invalid_argument, "Corrected without a function");
  require_above_zero("Corrected", "travel", limits.travel);
  require_above_zero("Corrected", "turn", limits.turn);
  require_above_zero("Corrected", "speed", limits.speed);
  require_above_zero("Corrected", "angular speed", limits.angular_speed);
  require_above_zero("Corrected", "acceleration", limits.acceleration);
  require_above_zero("Corrected", "angular acceleration", limits.angular_acceleration);
}

Corrected::~Corrected() = default;

void Corrected::start() { resume(); }

void Corrected::resume() {
  law_->displacement.reset();
  law_->saturated = false;
}

void Corrected::next_state() {
  Law& law = *law_;
  const CorrectionLimits& limits = law.limits;
  if (law.robot.state().at_rest()) law.displacement.halt();  // after a hold
  const Pose asked = law.correction();
  const Eigen::Vector3d way = asked.translation(), turn = rotation_vector(asked.linear());
  if (!asked.matrix().allFinite() || !turn.allFinite())
    throw NonFatalError(ErrorCode::not_finite, "Corrected: the correction",
                        {law.robot.task().process_name(), law.robot.name(), 0, law.robot.state().tick});
  law.saturated = way.norm() > limits.travel || turn.norm() > limits.turn;
  const Displacement::Axes& x = law.displacement.value();
  Displacement::Axes wanted;
  wanted << towards(at_most(way, limits.travel) - x.head<3>(), limits.speed, limits.acceleration),
      towards(at_most(turn, limits.turn) - x.tail<3>(), limits.angular_speed, limits.angular_acceleration);
  law.displacement.advance(wanted, kLag, law.robot.step_duration(), {limits.acceleration, limits.angular_acceleration});
  law.displacement.command(law.robot, superior().command(), "Corrected");
}

Pose Corrected::correction() const noexcept {
  const Displacement::Axes& x = law_->displacement.value();
  Pose pose = Pose::Identity();
  pose.translation() = x.head<3>();
  pose.linear() = exp_rotation(x.tail<3>());
  return pose;
}

bool Corrected::saturated() const noexcept { return law_->saturated; }

}  // namespace mrroc
