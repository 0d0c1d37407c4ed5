#include "mrroc/generators/contact_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/require.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/conditions/guard.hpp"
#include "language/force/force_step.hpp"
#include "language/limits.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kTravelGain = 4;  // 1/s, towards a place
constexpr double kArrived = 3e-4;  // m
constexpr double kMostForce = 2;   // times the contact force, between the probes
constexpr double kSettled = 0.05;  // of the contact force
constexpr int kSettledSteps = 5;
constexpr int kPatience = 100;   // steps for settling, and near a position that is not quite reached
constexpr double kTurnGain = 2;  // 1/s, back to the orientation

}  // namespace

std::vector<Probe> grid_of_probes(const Pose& frame, int columns, int rows, double spacing, double distance) {
  require(columns > 0 && rows > 0, "grid_of_probes", "columns and rows", std::min(columns, rows), "at least 1 each");
  require_above_zero("grid_of_probes", "spacing", spacing);
  std::vector<Probe> probes;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < columns; ++i) {
      const int column = row % 2 == 0 ? i : columns - 1 - i;
      probes.push_back({frame * Eigen::Vector3d(spacing * column, spacing * row, 0), frame.linear().col(2), distance});
    }
  }
  return probes;
}

ContactSearch::ContactSearch(Robot& robot, std::vector<Probe> probes, const Probing& probing)
    : Generator("ContactSearch"), robot_(&robot), probes_(std::move(probes)), probing_(probing) {
  require(!probes_.empty(), "ContactSearch", "probes", 0, "at least 1");
  for (Probe& probe : probes_) {
    require(probe.start.allFinite(), "ContactSearch", "start of a probe", probe.start.sum(), "finite numbers");
    require_above_zero("ContactSearch", "length of the direction of a probe", probe.direction.norm());
    require_above_zero("ContactSearch", "distance of a probe", probe.distance);
    probe.direction.normalize();
  }
  require_above_zero("ContactSearch", "speed", probing.speed);
  require_above_zero("ContactSearch", "force", probing.force);
  require_above_zero("ContactSearch", "travel speed", probing.travel_speed);
  require_above_zero("ContactSearch", "acceleration", probing.acceleration);
  check_load("ContactSearch", probing.load, probing.gravity);
  touched_.resize(probes_.size());
}

void ContactSearch::start() {
  probe_ = 0;
  std::fill(touched_.begin(), touched_.end(), std::nullopt);
  orientation_ = robot_->known_state().desired_pose.linear();
  phase_ = Phase::out;
  resume();
}

void ContactSearch::resume() {
  velocity_.setZero();
  if (phase_ != Phase::over) enter(touched_[probe_] ? Phase::back : Phase::out);
}

int ContactSearch::count() const noexcept {
  return static_cast<int>(
      std::count_if(touched_.begin(), touched_.end(), [](const auto& place) { return place.has_value(); }));
}

void ContactSearch::enter(Phase phase) noexcept {
  phase_ = phase;
  steps_ = settled_ = 0;
}

void ContactSearch::next_state() {
  update();
  ++steps_;
  const double most = probing_.acceleration * robot_->step_duration(), scale = robot_->task().operator_speed();
  Eigen::Vector3d wanted = Eigen::Vector3d::Zero();
  const Eigen::Vector3d place = robot_->state().pose.translation();
  if (phase_ == Phase::along) {
    // along the line from the start, and straight back onto it after a deviation
    const Eigen::Vector3d off = probe().start - place;
    wanted = scale * probing_.speed * probe().direction +
             kTravelGain * (off - off.dot(probe().direction) * probe().direction);
  } else if (phase_ == Phase::out || phase_ == Phase::back) {
    const Eigen::Vector3d way = probe().start - place;
    const double left = way.norm();
    if (left > 0)
      wanted =
          way / left * approach_speed(left, scale * probing_.travel_speed, 0.5 * probing_.acceleration, kTravelGain);
  }
  velocity_ = stepped(velocity_, wanted, most);
  command(velocity_);
}

/// Updates the phase from the measured state.
void ContactSearch::update() {
  const RobotState& state = robot_->state();
  const Eigen::Vector3d place = state.pose.translation();
  const Eigen::Vector3d force = state.pose.linear() * felt_without(state, probing_.load, probing_.gravity).head<3>();
  switch (phase_) {
    case Phase::out:
    case Phase::back: {
      const Eigen::Vector3d way = probe().start - place;
      const double left = way.norm(), met = -force.dot(way.normalized()), most = kMostForce * probing_.force;
      if (met > most) {
        throw NonFatalError(ErrorCode::force_limit,
                            number_text(met, most) + " N on the way to probe " + std::to_string(probe_ + 1) +
                                ", expected at most " + number_text(most, met),
                            {robot_->task().process_name(), robot_->name(), 0, state.tick});
      }
      if (left > kArrived && !(steps_ > kPatience && left < 3 * kArrived)) return;
      if (phase_ == Phase::out) return enter(Phase::along);
      if (probe_ + 1 == probes_.size()) return enter(Phase::over);
      ++probe_;
      return enter(Phase::out);
    }
    case Phase::along:
      if (-force.dot(probe().direction) >= probing_.force) {
        velocity_.setZero();
        return enter(Phase::pressing);
      }
      if ((place - probe().start).dot(probe().direction) >= probe().distance) enter(Phase::back);
      return;
    case Phase::pressing: {
      const double missing = probing_.force + force.dot(probe().direction);
      settled_ = std::abs(missing) < kSettled * probing_.force ? settled_ + 1 : 0;
      if (settled_ < kSettledSteps && steps_ < kPatience) return;
      touched_[probe_] = place;
      return enter(probing_.first_only ? Phase::over : Phase::back);
    }
    case Phase::over:
      return;
  }
}

void ContactSearch::command(const Eigen::Vector3d& velocity) {
  const RobotState& state = robot_->state();
  const Eigen::Matrix3d to_tool = state.desired_pose.linear().transpose();
  const bool probes = phase_ == Phase::along || phase_ == Phase::pressing;
  const Eigen::Vector3d direction = to_tool * (probes ? probe().direction : velocity.normalized());
  const Wrench weight = weight_of(probing_.load, state.pose.linear(), probing_.gravity);
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::force;
  command.twist.head<3>() = to_tool * velocity;
  command.twist.tail<3>() = kTurnGain * rotation_vector(to_tool * orientation_);
  const double speed = probes ? probing_.speed : probing_.travel_speed;
  // while it presses, the force settles as fast as at full speed
  const double scale = phase_ == Phase::pressing ? 1 : robot_->task().operator_speed();
  guard(command.force, direction * (scale * speed), probing_.force);
  for (int i = 0; i < 3; ++i) {
    if (command.force.behaviour[static_cast<std::size_t>(i)] != AxisBehaviour::guarded) continue;
    if (phase_ == Phase::pressing)
      command.force.contact(i, weight[i] - probing_.force * direction[i]);
    else
      command.twist[i] -= command.force.admittance[i] * weight[i];  // guarded is about a force of 0
  }
}

}  // namespace mrroc
