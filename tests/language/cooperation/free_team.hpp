#pragma once

#include "language/free_flyer.hpp"
#include "mrroc/move.hpp"

namespace mrroc::fakes {

/// A task with several robots, each a FreeModel that executes every command of a pose or of joints exactly, on one
/// grid: from rest all begin at the commanded tick.
class FreeTeam : public FakeTask {
 public:
  class Member : public RobotLink {
   public:
    Member(FakeTime& time, const Pose& start) : time_(time) {
      state.synchronised = state.enabled = true;
      state.desired_velocity = state.desired_acceleration = JointVector::Zero(6);
      state.tick = state.desired_tick = time.tick;
      place(start);
    }
    void place(const Pose& pose) {
      state.desired_pose = state.pose = pose;
      model->inverse(pose, {}, state.desired_joints);
    }
    void send(const RobotCommand& command) override {
      command_ = command;
      if (command.kind == CommandKind::query) return;
      commands.push_back(command);
      state.macrostep_start = std::max(command.start_tick, state.desired_tick);
    }
    void receive(RobotState& reply) override {
      if (command_.kind != CommandKind::query) {
        if (command_.kind == CommandKind::hold && overrun > 0) {
          const Twist way = overrun * state.desired_velocity;
          Pose pose = state.desired_pose;
          pose.translation() += way.head<3>();
          pose.linear() = exp_rotation(way.tail<3>()) * pose.linear();
          place(pose);
        }
        state.desired_velocity.setZero();
        state.desired_acceleration.setZero();
        if (command_.kind == CommandKind::pose) {
          place(command_.pose);
          state.desired_velocity = command_.twist;
          if (command_.twist_acceleration.size() > 0) state.desired_acceleration = command_.twist_acceleration;
        } else if (command_.kind == CommandKind::joint) {
          place(model->flange(command_.joints));
          if (command_.joint_velocity.size() > 0) state.desired_velocity = command_.joint_velocity;
          if (command_.joint_acceleration.size() > 0) state.desired_acceleration = command_.joint_acceleration;
        }
        if (commands.size() == late_at) ++state.late_commands;
        state.tick = state.desired_tick = state.macrostep_start + command_.motion_steps;
        state.joints = state.desired_joints;
        time_.reach(state.tick);
      }
      reply = state;
    }

    RobotState state;
    std::vector<RobotCommand> commands;  ///< all but queries
    std::size_t late_at = 0;             ///< number of the late command, from 1; 0: none
    double overrun = 0;                  ///< s: duration of the motion after a `hold`
    std::shared_ptr<FreeModel> model = std::make_shared<FreeModel>(FreeModel::Range::unlimited);

   private:
    FakeTime& time_;
    RobotCommand command_;
  };

  /// `starts`: poses of the tools in their bases.
  explicit FreeTeam(const std::vector<Pose>& starts) {
    log.recording = false;
    for (const Pose& start : starts) members.push_back(std::make_unique<Member>(time, start));
    for (std::size_t i = 0; i < starts.size(); ++i) {
      arms.push_back(std::make_unique<Robot>(*this, std::to_string(i), RobotModels{members[i]->model}));
      arms.back()->set_macrostep(10, 10);
    }
  }
  RobotLink& robot_link(const std::string& name, const std::string&) override { return *members.at(std::stoul(name)); }
  RobotList list() const {
    std::vector<Robot*> robots;
    for (const auto& arm : arms) robots.push_back(arm.get());
    return RobotList(robots);
  }

  std::vector<std::unique_ptr<Member>> members;
  std::vector<std::unique_ptr<Robot>> arms;
};

}  // namespace mrroc::fakes
