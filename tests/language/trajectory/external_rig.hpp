#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/quintic.hpp"
#include "language/fakes.hpp"
#include "language/limit_check.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/generators/external.hpp"
#include "mrroc/joint_trajectory.hpp"
#include "mrroc/move.hpp"
#include "mrroc/stopped.hpp"
#include "mrroc/trajectory_link.hpp"

namespace mrroc::fakes::external_test {

using Order = JointTrajectory::Order;

class FakeLink : public TrajectoryLink {
 public:
  bool take(const FixedText<kNameLength>& robot, TrajectoryPart& part) override {
    if (parts.empty() || !(parts.front().robot == robot)) return false;
    part = parts.front();
    parts.pop_front();
    return true;
  }
  void report(const TrajectoryReport& report) override { reports.push_back(report); }

  void send(std::uint64_t number, const JointTrajectory& trajectory) {
    const auto numbers = trajectory.numbers();
    for (std::size_t begin = 0; begin < numbers.size(); begin += TrajectoryPart::kNumbers) {
      TrajectoryPart part;
      part.robot.assign("arm");
      part.trajectory = number;
      part.size = static_cast<std::uint32_t>(numbers.size());
      part.begin = static_cast<std::uint32_t>(begin);
      part.count = static_cast<std::uint16_t>(std::min(TrajectoryPart::kNumbers, numbers.size() - begin));
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(begin), part.count, part.numbers.begin());
      parts.push_back(part);
    }
  }
  void cancel(std::uint64_t number) {
    TrajectoryPart part;
    part.robot.assign("arm");
    part.order = TrajectoryOrder::cancel;
    part.trajectory = number;
    parts.push_back(part);
  }
  std::vector<TrajectoryState> states() const {
    std::vector<TrajectoryState> all;
    for (const TrajectoryReport& report : reports) all.push_back(report.state);
    return all;
  }

  std::deque<TrajectoryPart> parts;
  std::vector<TrajectoryReport> reports;
};

class YieldingTask : public FakeTask {
 public:
  TrajectoryLink* trajectory_link() noexcept override { return &link; }
  FakeLink link;
};

/// A Move with External, watched before each step; ends by throwing Stopped at the step `last`.
class Rig {
 public:
  explicit Rig(int last) : last_(last) { robot = task.robot("arm"); }

  class Watched : public Generator {
   public:
    Watched(Rig& rig, External& inner) : Generator("Watched"), rig_(rig), inner_(inner) {}
    void start() override { inner_.start(); }
    void resume() override { inner_.resume(); }
    bool brake() override { return inner_.brake(); }
    void finish() noexcept override { inner_.finish(); }
    void next_state() override {
      if (rig_.step == rig_.last_) throw Stopped{};
      if (rig_.before) rig_.before(rig_.step);
      inner_.next_state();
      rig_.look();
      ++rig_.step;
    }

   private:
    Rig& rig_;
    External& inner_;
  };

  void run() {
    External external(*robot);
    Watched watched(*this, external);
    EXPECT_THROW(Move({*robot}, {}, watched), Stopped);
  }

  JointVector joints() const { return robot->state().desired_joints; }
  std::size_t axes() const { return robot->parameters().axes.size(); }

  YieldingTask task;
  std::unique_ptr<Robot> robot;
  int step = 0;
  std::function<void(int step)> before;
  std::vector<DesiredState> ends;  ///< of every command

 private:
  void look() {
    const RobotState& state = robot->state();
    const RobotCommand& command = robot->command();
    DesiredState from{state.desired_joints, state.desired_velocity, state.desired_acceleration};
    if (command.kind != CommandKind::joint) {
      ends.push_back(from);
      return;
    }
    const DesiredState to{command.joints, command.joint_velocity, command.joint_acceleration};
    ends.push_back(to);
    Quintic path;
    path.plan(from, to, 0.02);
    LimitCheck check(*robot->models().front(), 0.002);
    const ErrorReport report = check.check(from, to, 10, &path, [&](double t, const JointVector&, DesiredState& at) {
      at = path.at(t);
      return ErrorCode::none;
    });
    RC_ASSERT(report.code == ErrorCode::none);
  }

  int last_;
};

}  // namespace mrroc::fakes::external_test
