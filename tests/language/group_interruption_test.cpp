// Interrupted Moves of robots that move together: what their generator is asked for, and that they come to rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "language/drive.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/move.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::group_interruption_test {
namespace {

using fakes::Action;
using fakes::Call;
using fakes::Drive;
using fakes::FakeTask;

struct Cell : FakeTask {
  /// Both robots are in motion afterwards.
  void set_in_motion() { Move({*left, *right}, {}, Drive{{left.get(), right.get()}}.until(ElapsedSteps{2})); }
  std::size_t count(CommandKind kind) const {
    return static_cast<std::size_t>(std::count_if(log.calls.begin(), log.calls.end(), [kind](const Call& call) {
      return call.action == Action::send && call.kind == kind;
    }));
  }
  bool at_rest() const { return left->state().at_rest() && right->state().at_rest(); }
  std::unique_ptr<Robot> left = robot("left"), right = robot("right");
  std::unique_ptr<Sensor> gate = sensor("gate");
};

/// Constant velocity along a path; its state may be asked for only between its start and its end after `length` steps.
class Guarded : public Generator {
 public:
  Guarded(Robot& robot, int length) : Generator("Guarded"), robot_(&robot), length_(length) {}
  void start() override { left_ = length_; }
  bool terminal_condition() override { return left_ == 0; }
  void next_state() override {
    ASSERT_GT(left_, 0);
    --left_;
    const Eigen::Index axes = robot_->state().desired_joints.size();
    RobotCommand& command = robot_->command();
    command.kind = CommandKind::joint;
    command.joint_velocity = JointVector::Constant(axes, 0.1);
    command.joint_acceleration = JointVector::Zero(axes);
    command.joints = robot_->state().desired_joints + 0.1 * robot_->step_duration() * JointVector::Ones(axes);
  }

 private:
  Robot* robot_;
  int length_, left_ = -1;
};

class Refusing : public Guarded {
 public:
  using Guarded::Guarded;
  void start() override { throw NonFatalError("cannot start"); }
};

class Pressing : public Generator {
 public:
  explicit Pressing(Robot& robot) : Generator("Pressing"), robot_(&robot) {}
  void next_state() override { robot_->command().kind = CommandKind::force; }

 private:
  Robot* robot_;
};

class Unready : public Condition {
 public:
  Unready() : Condition("Unready") {}
  void start() override { throw NonFatalError("not ready"); }

 private:
  bool holds() override { return false; }
};

TEST(GroupInterruption, GeneratorThatHasNotStartedIsAskedForNothing) {
  for (const int kind : {0, 1, 2}) {
    SCOPED_TRACE(kind);
    Cell cell;
    cell.set_in_motion();
    ASSERT_FALSE(cell.at_rest());
    Guarded left{*cell.left, 9}, right{*cell.right, 9};
    Refusing refusing{*cell.right, 9};
    if (kind == 1) cell.sensor_fake("gate").errors[0] = {ErrorClass::non_fatal, ErrorCode::sensor_not_ready, {}};
    const auto move = [&] {
      if (kind == 0) Move({*cell.left, *cell.right}, {}, Together{left, refusing});
      if (kind == 1) Move({*cell.left, *cell.right}, {*cell.gate}, Together{left, right});
      if (kind == 2) Move({*cell.left, *cell.right}, {}, Together{left, right}.until(Unready{}));
    };
    EXPECT_THROW(move(), NonFatalError);
    EXPECT_TRUE(cell.at_rest());
    cell.set_in_motion();  // the next Move works
  }
}

TEST(GroupInterruption, GeneratorThatHasEndedIsAskedForNothing) {
  for (const std::uint64_t at : {1, 2, 3, 4, 5}) {
    SCOPED_TRACE(at);
    Cell cell;
    cell.sensor_fake("gate").errors[at] = {ErrorClass::non_fatal, ErrorCode::sensor_not_ready, {}};
    EXPECT_THROW(
        Move({*cell.left, *cell.right}, {*cell.gate}, Together{Guarded{*cell.left, 3}, Guarded{*cell.right, 5}}),
        NonFatalError);
    EXPECT_TRUE(cell.at_rest());
  }
}

TEST(GroupInterruption, PauseHoldsRobotsThatCannotBeBrakedOnTheirWay) {
  const auto pressing = [](Cell& cell) { return Together{Pressing{*cell.left}, Pressing{*cell.right}}; };
  const auto mixed = [](Cell& cell) { return Together{Guarded{*cell.left, 1000}, Pressing{*cell.right}}; };
  const auto uneven = [](Cell& cell) {
    cell.left->set_macrostep(20, 18);
    return Together{Guarded{*cell.left, 1000}, Guarded{*cell.right, 1000}};
  };
  for (const std::function<Together(Cell&)>& motion :
       {std::function<Together(Cell&)>{pressing}, std::function<Together(Cell&)>{mixed},
        std::function<Together(Cell&)>{uneven}}) {
    for (const double speed : {1.0, 0.5}) {
      for (const OperatorRequest request :
           {OperatorRequest::pause, OperatorRequest::end_motion, OperatorRequest::stop}) {
        SCOPED_TRACE(testing::Message() << "speed " << speed << ", request " << static_cast<int>(request));
        Cell cell;
        cell.speed = speed;
        cell.requests = {OperatorRequest::none, OperatorRequest::none, OperatorRequest::none};
        cell.requests.resize(request == OperatorRequest::pause ? 40 : 4, request);
        Together together = motion(cell);
        const auto move = [&] { Move({*cell.left, *cell.right}, {}, together.until(ElapsedSteps{12})); };
        if (request == OperatorRequest::stop) {
          EXPECT_THROW(move(), Stopped);
        } else {
          move();
        }
        const std::size_t holds = cell.count(CommandKind::hold);
        if (request == OperatorRequest::pause) {
          EXPECT_GT(holds, 60u);  // of two robots, in 37 queries
        } else {
          EXPECT_LT(cell.log.calls.size(), 120u) << "it does not brake for 500 steps";
        }
      }
    }
  }
}

}  // namespace
}  // namespace mrroc::group_interruption_test
