#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "edp/command/planner.hpp"
#include "generators/cell_task.hpp"

namespace mrroc::test {

/// A task process around one robot at rest at home. Its EDP's planner answers every command: it plans and checks the
/// command as in the EDP, refuses it with the EDP's error, or executes it exactly and at once. `on_tick` receives every
/// tick of every path.
class PlannedCell : public CellTask, private RobotLink {
 public:
  explicit PlannedCell(std::shared_ptr<const RobotModel> model)
      : model_(std::move(model)), planner_(*model_, kPeriod), tool_(*model_) {
    state_.synchronised = state_.enabled = true;
    state_.tool = tool_.tool();
    state_.tick = state_.desired_tick = now_;
    now_state_ = DesiredState::resting_at(model_->parameters().home);
    tell();
  }

  std::string robot_name(const std::string&) const override { return "arm"; }
  RobotLink& robot_link(const std::string&, const std::string&) override { return *this; }
  Tick tick() const noexcept override { return now_; }
  void sleep_until(Tick tick) override { now_ = std::max(now_, tick); }
  /// From the step `pause_at` on the operator requests "pause" so many times.
  OperatorRequest operator_request() noexcept override {
    const int asked = asked_++;
    return asked >= pause_at && asked < pause_at + 3 ? OperatorRequest::pause : OperatorRequest::none;
  }

  const ToolKinematics& kinematics() const noexcept { return tool_; }
  const std::vector<AxisParameters>& axes() const { return model_->parameters().axes; }
  const DesiredState& desired() const noexcept { return now_state_; }

  int pause_at = 1 << 30;
  bool is_pausing() const noexcept { return asked_ > pause_at; }
  /// The desired state, the one a tick before it, and the command in execution.
  std::function<void(const DesiredState&, const DesiredState&, const RobotCommand&)> on_tick;

 private:
  void tell() {
    state_.joints = state_.desired_joints = now_state_.position;
    state_.joint_velocity = state_.desired_velocity = now_state_.velocity;
    state_.desired_acceleration = now_state_.acceleration;
    state_.pose = state_.desired_pose = tool_.direct(now_state_.position);
  }
  void send(const RobotCommand& command) override { command_ = command; }
  void receive(RobotState& reply) override {
    state_.error = {};
    if (command_.kind != CommandKind::query) execute();
    reply = state_;
  }
  void execute() {
    edp::Macrostep macrostep;
    state_.error = planner_.plan(command_, now_state_, edp::Pace::as_commanded, macrostep);
    if (state_.error.error_class != ErrorClass::none) return;
    now_ += macrostep.steps;
    if (macrostep.kind == edp::Macrostep::Kind::path && on_tick) {
      DesiredState before = now_state_;
      for (std::uint32_t k = 1; k <= macrostep.steps; ++k) {
        DesiredState state = macrostep.to;
        if (k < macrostep.steps) macrostep.path.at(k * kPeriod, before.position, state);
        on_tick(state, before, command_);
        before = state;
      }
    }
    now_state_ = macrostep.to;
    state_.tick = state_.desired_tick = now_;
    tell();
  }

  std::shared_ptr<const RobotModel> model_;
  edp::Planner planner_;
  ToolKinematics tool_;
  RobotState state_;
  RobotCommand command_;
  DesiredState now_state_;
  Tick now_ = 1000;
  int asked_ = 0;
};

}  // namespace mrroc::test
