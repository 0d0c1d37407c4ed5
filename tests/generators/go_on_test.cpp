// After a caught refusal the next motion works at once, for any refusal and any next motion.
#include <gtest/gtest.h>

#include <functional>

#include "generators/loopback_cell.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/conditions/elapsed_time.hpp"
#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/joint_path.hpp"
#include "mrroc/generators/tool_velocity.hpp"
#include "mrroc/move.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::test::go_on_test {
namespace {

/// Commands one joint a constant velocity or acceleration, from rest, until the EDP refuses it.
class Drive : public Generator {
 public:
  Drive(std::vector<Robot*> robots, Eigen::Index axis, double velocity, bool by_position)
      : Generator("Drive"), robots_(std::move(robots)), axis_(axis), target_(velocity), by_position_(by_position) {}
  void start() override { velocity_ = 0; }
  bool terminal_condition() override { return false; }
  void next_state() override {
    const double before = velocity_;
    for (Robot* robot : robots_) {
      const AxisParameters& axis = robot->parameters().axes[static_cast<std::size_t>(axis_)];
      const double change = 0.3 * axis.acceleration_max * robot->step_duration();
      velocity_ = target_ > 0 ? std::min(target_, before + change) : std::max(target_, before - change);
      RobotCommand& command = robot->command();
      const Eigen::Index count = robot->state().desired_joints.size();
      command.kind = by_position_ ? CommandKind::joint : CommandKind::joint_velocity;
      command.joint_velocity = JointVector::Zero(count);
      command.joint_velocity[axis_] = velocity_;
      command.relative = by_position_;
      command.joints = 0.5 * robot->step_duration() * (command.joint_velocity + robot->state().desired_velocity);
    }
  }

 private:
  std::vector<Robot*> robots_;
  Eigen::Index axis_;
  double target_;
  bool by_position_;
  double velocity_ = 0;
};

/// Throws its own error in the middle of a motion.
class Failing : public Drive {
 public:
  using Drive::Drive;
  void next_state() override {
    if (++steps_ == 15) throw NonFatalError(ErrorCode::invalid_argument, "its own error");
    Drive::next_state();
  }

 private:
  int steps_ = 0;
};

struct Named {
  std::string name;
  std::function<void(LoopbackCell&)> move;
};

std::vector<Named> refusals() {
  std::vector<Named> all;
  for (Eigen::Index axis = 0; axis < 6; ++axis)
    for (const double way : {-1.0, 1.0})
      for (const bool by_position : {false, true})
        all.push_back(
            {"axis " + std::to_string(axis + 1) + (way > 0 ? " up" : " down") + (by_position ? ", position" : ""),
             [=](LoopbackCell& cell) {
               const double v = cell.robot().parameters().axes[static_cast<std::size_t>(axis)].velocity_max;
               Move({cell.robot()}, {}, Drive{{&cell.robot()}, axis, 0.9 * way * v, by_position});
             }});
  all.push_back({"velocity", [](LoopbackCell& cell) {
                   const double v = cell.robot().parameters().axes[0].velocity_max;
                   Move({cell.robot()}, {}, Drive{{&cell.robot()}, 0, 1.2 * v, false});
                 }});
  all.push_back({"thrown by the generator", [](LoopbackCell& cell) {
                   Move({cell.robot()}, {}, Failing{{&cell.robot()}, 1, 0.5, false});
                 }});
  all.push_back({"workspace", [](LoopbackCell& cell) {
                   Move({cell.robot()}, {}, ToolVelocity{cell.robot(), Eigen::Vector3d(0, 0, 0.3)});
                 }});
  all.push_back({"sideways", [](LoopbackCell& cell) {
                   Move({cell.robot()}, {}, ToolVelocity{cell.robot(), Eigen::Vector3d(0.3, 0, 0)});
                 }});
  all.push_back({"before it begins", [](LoopbackCell& cell) {
                   JointVector far = cell.robot().parameters().home;
                   far[1] = cell.robot().parameters().axes[1].position_max;
                   Move({cell.robot()}, {}, JointLine{cell.robot(), far});
                 }});
  return all;
}

std::vector<Named> next_motions() {
  const auto near = [](LoopbackCell& cell) { return cell.robot().state().desired_joints; };
  return {{"home",
           [](LoopbackCell& cell) {
             Move({cell.robot()}, {}, JointLine{cell.robot(), cell.robot().parameters().home, 1});
           }},
          {"home by a path",
           [](LoopbackCell& cell) {
             Move({cell.robot()}, {},
                  JointPath{cell.robot(), std::vector<JointVector>{cell.robot().parameters().home}, 0.8});
           }},
          {"hold",
           [](LoopbackCell& cell) {
             Move({cell.robot()}, {}, Hold{cell.robot(), 0.2});
           }},
          {"slow line",
           [near](LoopbackCell& cell) {
             const JointVector home = cell.robot().parameters().home;
             Move({cell.robot()}, {}, JointLine{cell.robot(), near(cell) + 0.01 * (home - near(cell)), 0.1});
           }},
          {"line of the tool",
           [near](LoopbackCell& cell) {
             const JointVector home = cell.robot().parameters().home;
             const Pose pose = cell.robot().kinematics().direct(near(cell) + 0.02 * (home - near(cell)));
             Move({cell.robot()}, {}, CartesianLine{cell.robot(), pose});
           }},
          {"velocity back", [near](LoopbackCell& cell) {
             const JointVector home = cell.robot().parameters().home;
             const Pose back = cell.robot().state().desired_pose.inverse() *
                               cell.robot().kinematics().direct(near(cell) + 0.01 * (home - near(cell)));
             const Twist twist = (Twist() << back.translation(), rotation_vector(back.linear())).finished() / 0.3;
             Move({cell.robot()}, {},
                  ToolVelocity{cell.robot(), twist.head<3>(), twist.tail<3>()}.until(ElapsedTime{cell, 0.1}));
           }}};
}

TEST(GoOn, AfterEveryRefusalWithEveryMotion) {
  const auto model = load_irb6().front();
  for (const Named& refusal : refusals())
    for (const Named& next : next_motions()) {
      SCOPED_TRACE(refusal.name + ", then " + next.name);
      LoopbackCell cell({model});
      std::string text;
      try {
        refusal.move(cell);
        ADD_FAILURE() << "not refused";
      } catch (const NonFatalError& error) {
        text = error.what();
      }
      EXPECT_TRUE(cell.robot().state().desired_velocity.isZero(0));
      try {
        next.move(cell);
      } catch (const NonFatalError& error) {
        ADD_FAILURE() << "after " << text << ": " << error.what();
      }
      EXPECT_EQ(cell.robot().state().late_commands, 0u);
    }
}

TEST(GoOn, AllRobotsOfAMoveRestAfterTheRefusalOfOne) {
  const auto model = load_irb6().front();
  LoopbackCell cell({model, model, model});
  std::vector<Robot*> all{&cell.robot(0), &cell.robot(1), &cell.robot(2)};
  const auto home = [&] {
    for (Robot* robot : all) Move({*robot}, {}, JointLine{*robot, robot->parameters().home});
  };
  // the second robot is nearer to its limit
  Move(RobotList(all), {}, Hold{*all[0], 0.1});
  JointVector ahead = model->parameters().home;
  ahead[0] += 0.5;
  Move({*all[1]}, {}, JointLine{*all[1], ahead});
  EXPECT_THROW(Move(RobotList(all), {}, Drive(all, 0, 1.0, false)), NonFatalError);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(all[i]->state().desired_velocity.isZero(0));
    EXPECT_EQ(all[i]->state().error.error_class, ErrorClass::none);
  }
  EXPECT_NO_THROW(home());
}

}  // namespace
}  // namespace mrroc::test::go_on_test
