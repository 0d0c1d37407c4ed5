// The state that the replies carry.
#include <algorithm>

#include "edp/command/effector.hpp"
#include "edp/force/force_law.hpp"
#include "edp/safety/error_report.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {

void Effector::answer(std::uint64_t number, const ErrorReport& error, Reply& reply) noexcept {
  reply.command = number;
  reply.state = RobotState{};
  fill_present(reply.state);
  if (bad(error)) {
    reply.state.error = error;
    ++counters_.refused;
  }
  unreported_ = joined_ = false;
}

bool Effector::peek(RobotState& state) noexcept {
  refresh();
  fill_present(state);
  return snapshot_ != nullptr;
}

void Effector::fill_present(RobotState& state) const noexcept {
  if (snapshot_ == nullptr) return;
  if (snapshot_->enabled())
    fill(*snapshot_, end_, std::max(end_tick_, snapshot_->tick), state);
  else
    fill(*snapshot_, snapshot_->end, snapshot_->end_tick, state);
}

void Effector::fill(const Snapshot& snapshot, const DesiredState& end, Tick end_tick,
                    RobotState& state) const noexcept {
  static_cast<MeasuredState&>(state) = snapshot;
  state.model = model_;  // the model that gives the poses
  state.wrench = mount_ ? seen_from(mount_->inverse() * tool_, snapshot.wrench) : Wrench::Zero();
  state.pose = planner_.kinematics().direct(snapshot.joints);
  state.macrostep_start = macrostep_start_;
  state.desired_tick = end_tick;
  state.desired_joints = end.position;
  state.desired_velocity = end.velocity;
  state.desired_acceleration = end.acceleration;
  state.desired_pose = planner_.kinematics().direct(end.position);
  state.tool = tool_;
  state.enabled = snapshot.enabled();
  state.late_commands = counters_.late;
  state.error =
      snapshot.fault.code == ErrorCode::none ? ErrorReport{} : make_report(snapshot.fault, models_.parameters());
}

}  // namespace mrroc::edp
