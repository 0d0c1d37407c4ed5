// Arms that carry an object come to rest on its path, however their Move ends.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "language/cooperation/object_path.hpp"
#include "language/force/elastic_object.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/cooperative_motion.hpp"
#include "mrroc/move.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::common_stop_test {
namespace {

using fakes::check_property;
using fakes::ElasticObject;
using fakes::pick;
using fakes::way;

constexpr int kStops = 200;

/// The steps until the path is near its end.
std::size_t any_step(const CooperativeMotion& motion) {
  return static_cast<std::size_t>(pick(1, static_cast<int>(motion.duration() / 0.02) - 1));
}

/// Arms that move on for some time when each brakes by itself.
void let_overrun(ElasticObject& cell) {
  for (auto& member : cell.team->members) member->overrun = 0.001 * pick(1, 50);
}
/// From the step of the interruption on all arms carry the object, on its path, until they rest.
void check_common_stop(const ElasticObject& cell, const ObjectPath& path, std::size_t from) {
  const auto& commands = cell.team->members[0]->commands;
  RC_ASSERT(commands.size() > from);
  std::size_t last = 0;
  for (std::size_t k = 0; k < commands.size(); ++k) {
    if (commands[k].kind != CommandKind::pose) continue;
    last = k;
    const Pose object = cell.carried(0, k);
    for (std::size_t arm = 1; arm < cell.bases.size(); ++arm) RC_ASSERT(way(cell.carried(arm, k), object) < 1e-9);
  }
  for (const auto& member : cell.team->members) {
    RC_ASSERT(member->commands[last].twist.norm() < 1e-12);
    RC_ASSERT(member->state.at_rest());
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (double t = 0; t <= path.duration(); t += 1e-3)
    nearest = std::min(nearest, way(path.at(t), cell.carried(0, last)));
  RC_ASSERT(nearest < 5e-4);
}

TEST(CommonStop, EndOfTheMotionAndStopLeadTheObjectToRestOnItsPath) {
  check_property(kStops, [] {
    ElasticObject cell(pick(2, 4));
    let_overrun(cell);
    CooperativeMotion motion(cell.arms(false), cell.path);
    const std::size_t at = any_step(motion);
    cell.team->requests.assign(at, OperatorRequest::none);
    const bool stop = pick(0, 1) == 1;
    cell.team->requests.push_back(stop ? OperatorRequest::stop : OperatorRequest::end_motion);
    motion.until(ElapsedSteps{20000});
    if (stop) {
      RC_ASSERT_THROWS_AS(cell.move(motion), Stopped);
    } else {
      RC_ASSERT(cell.move(motion).ending == Ending::end_motion);
    }
    check_common_stop(cell, ObjectPath(cell.path, {}), at);
  });
}

TEST(CommonStop, ErrorOfASensorLeadsTheObjectToRestOnItsPath) {
  check_property(kStops, [] {
    ElasticObject cell(pick(2, 4));
    let_overrun(cell);
    const auto gate = cell.team->sensor("gate");
    CooperativeMotion motion(cell.arms(false), cell.path);
    const std::size_t at = any_step(motion);
    cell.team->sensor_fake("gate").errors[at] = {
        pick(0, 1) == 1 ? ErrorClass::non_fatal : ErrorClass::hardware, ErrorCode::sensor_out_of_range, {}};
    RC_ASSERT_THROWS_AS(Move(cell.team->list(), {*gate}, motion.until(ElapsedSteps{20000})), Error);
    check_common_stop(cell, ObjectPath(cell.path, {}), at);
  });
}

/// Two robots side by side on a sine, by a generator that knows of no interruption.
class SideBySide : public Generator {
 public:
  SideBySide(Robot& left, Robot& right) : Generator("SideBySide"), left_(&left), right_(&right) {}
  void start() override { from_ = {left_->state().desired_pose, right_->state().desired_pose}; }
  void resume() override { FAIL() << "the Move has ended, step " << step_; }
  bool terminal_condition() override { return step_ == kSteps; }
  void next_state() override {
    const double t = ++step_ / double{kSteps}, turn = 2 * std::numbers::pi;
    Twist twist = Twist::Zero();
    twist[0] = kWay / (kSteps * left_->step_duration()) * (1 - std::cos(turn * t));
    for (std::size_t i = 0; i < 2; ++i) {
      RobotCommand& command = (i == 0 ? left_ : right_)->command();
      command.kind = CommandKind::pose;
      command.pose = Eigen::Translation3d(kWay * (t - std::sin(turn * t) / turn), 0, 0) * from_[i];
      command.twist = twist;
      command.twist_acceleration = JointVector::Zero(6);
      command.twist_acceleration[0] = kWay / std::pow(kSteps * left_->step_duration(), 2) * turn * std::sin(turn * t);
    }
  }

 private:
  static constexpr int kSteps = 200;
  static constexpr double kWay = 0.4;  // m
  Robot* left_;
  Robot* right_;
  std::array<Pose, 2> from_;
  int step_ = 0;
};

TEST(CommonStop, GeneratorThatCannotBrakeIsSlowedDownOnItsWay) {
  check_property(kStops, [] {
    fakes::FreeTeam team({Pose(Eigen::Translation3d(0, 0.3, 0)), Pose(Eigen::Translation3d(0, -0.3, 0))});
    for (auto& member : team.members) member->overrun = 0.001 * pick(1, 50);
    SideBySide motion(*team.arms[0], *team.arms[1]);
    const auto at = static_cast<std::size_t>(pick(2, 190));
    team.requests.assign(at, OperatorRequest::none);
    team.requests.push_back(OperatorRequest::end_motion);
    RC_ASSERT(Move(team.list(), {}, motion).ending == Ending::end_motion);
    for (const auto& member : team.members) RC_ASSERT(member->state.at_rest());
    const Eigen::Vector3d apart =
        team.members[0]->state.desired_pose.translation() - team.members[1]->state.desired_pose.translation();
    RC_ASSERT((apart - Eigen::Vector3d(0, 0.6, 0)).norm() < 1e-9);
    RC_ASSERT(std::abs(team.members[0]->state.desired_pose.translation().y() - 0.3) < 1e-9);
  });
}

/// It claims to bring its robots to rest, and does not.
class Unstoppable : public Generator {
 public:
  Unstoppable(Robot& left, Robot& right) : Generator("Unstoppable"), robots_{&left, &right} {}
  bool brake() override { return true; }
  void next_state() override {
    for (Robot* robot : robots_) {
      robot->command().kind = CommandKind::pose;
      robot->command().pose = Eigen::Translation3d(0.001, 0, 0) * robot->state().desired_pose;
      robot->command().twist[0] = 0.05;
    }
  }

 private:
  std::array<Robot*, 2> robots_;
};

TEST(CommonStop, GeneratorThatDoesNotComeToRestCannotKeepTheMoveFromEnding) {
  for (const OperatorRequest request : {OperatorRequest::end_motion, OperatorRequest::stop}) {
    fakes::FreeTeam team({Pose(Eigen::Translation3d(0, 0.3, 0)), Pose(Eigen::Translation3d(0, -0.3, 0))});
    team.requests = {OperatorRequest::none, OperatorRequest::none, request};
    Unstoppable motion(*team.arms[0], *team.arms[1]);
    motion.until(ElapsedSteps{20000});
    if (request == OperatorRequest::stop) {
      EXPECT_THROW(Move(team.list(), {}, motion), Stopped);
    } else {
      const Outcome outcome = Move(team.list(), {}, motion);
      EXPECT_EQ(outcome.ending, Ending::end_motion);
      EXPECT_EQ(outcome.steps, 502U);
    }
  }
}

TEST(CommonStop, ErrorOfASensorEndsTheMoveOfAGeneratorThatDoesNotComeToRest) {
  fakes::FreeTeam team({Pose(Eigen::Translation3d(0, 0.3, 0)), Pose(Eigen::Translation3d(0, -0.3, 0))});
  const auto gate = team.sensor("gate");
  team.sensor_fake("gate").errors[3] = {ErrorClass::non_fatal, ErrorCode::sensor_out_of_range, {}};
  Unstoppable motion(*team.arms[0], *team.arms[1]);
  EXPECT_THROW(Move(team.list(), {*gate}, motion.until(ElapsedSteps{20000})), NonFatalError);
  for (const auto& member : team.members) EXPECT_TRUE(member->state.at_rest());
}

}  // namespace
}  // namespace mrroc::common_stop_test
