#include "mrroc/generators/cooperative_motion.hpp"

#include <limits>

#include "language/cooperation/object_path.hpp"
#include "language/force/elastic_object.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::cooperative_motion_test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using fakes::check_property;
using fakes::ElasticObject;
using fakes::kSoft;
using fakes::pick;
using fakes::random_vector;
using fakes::turn;
using fakes::way;

constexpr int kCases = 60;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(CooperativeMotion, GraspsFollowTheObjectRigidly) {
  check_property(kCases, [] {
    ElasticObject cell(pick(1, 4));
    const CooperativeLimits limits{.speed = 0.01 * pick(2, 20)};
    CooperativeMotion motion(cell.arms(false), cell.path, limits);
    const ObjectPath path(cell.path, limits);
    RC_ASSERT(cell.move(motion.until(ElapsedSteps{20000})).ending == Ending::generator);
    const std::size_t count = cell.team->members[0]->commands.size();
    const double step = cell.team->arms[0]->step_duration();
    for (std::size_t k = 0; k < count; ++k) {
      const Pose object = path.at(static_cast<double>(k + 1) * step);
      for (std::size_t i = 0; i < cell.bases.size(); ++i) {
        RC_ASSERT(way(cell.carried(i, k), object) < 1e-9);
        RC_ASSERT(turn(cell.carried(i, k), object) < 1e-9);
      }
    }
    RC_ASSERT(way(motion.object(), cell.path.back()) < 1e-9);
  });
}

TEST(CooperativeMotion, AllArmsAreCommandedInEveryStepOnOneGridAndRestAtTheEnd) {
  check_property(kCases, [] {
    ElasticObject cell(pick(2, 4), 1e-4);
    CooperativeMotion motion(cell.arms(true), cell.path, {}, kSoft);
    const Outcome end = cell.move(motion.until(ElapsedSteps{20000}));
    RC_ASSERT(end.ending == Ending::generator);
    RC_ASSERT(end.skew == 0u);
    const auto& first = cell.team->members[0]->commands;
    RC_ASSERT(first.size() == end.steps);
    for (const auto& member : cell.team->members) {
      RC_ASSERT(member->commands.size() == first.size());
      for (std::size_t k = 0; k < first.size(); ++k) {
        RC_ASSERT(member->commands[k].kind == CommandKind::pose);
        RC_ASSERT(member->commands[k].start_tick == first[k].start_tick);
      }
      RC_ASSERT(member->commands.back().twist.isZero(0));
    }
  });
}

TEST(CooperativeMotion, TwistIsThePosesDerivativeAndItsRateTheTwists) {
  check_property(20, [] {
    ElasticObject cell(2, 1e-4);
    for (auto& arm : cell.team->arms) arm->set_macrostep(1, 1);
    CooperativeMotion motion(cell.arms(true), cell.path, {}, kSoft);
    cell.move(motion.until(ElapsedSteps{1000}));
    const double dt = cell.team->servo_period();
    for (const auto& member : cell.team->members) {
      const auto& commands = member->commands;
      for (std::size_t k = 1; k + 1 < commands.size(); ++k) {
        const Vector3d moved = commands[k + 1].pose.translation() - commands[k - 1].pose.translation();
        const Vector3d turned =
            rotation_vector(commands[k + 1].pose.linear() * commands[k - 1].pose.linear().transpose());
        RC_ASSERT((moved / (2 * dt) - commands[k].twist.head<3>()).norm() < 1e-4);
        RC_ASSERT((turned / (2 * dt) - commands[k].twist.tail<3>()).norm() < 1e-4);
        const Twist change = commands[k + 1].twist - commands[k - 1].twist;
        RC_ASSERT((change / (2 * dt) - Twist(commands[k].twist_acceleration)).norm() < 2e-2);
      }
    }
  });
}

// errors of the grasp and of the arms show as internal wrench; the object keeps its position while they are relieved
TEST(CooperativeMotion, RelievesTheInternalForceToTheDesiredOne) {
  check_property(kCases, [] {
    ElasticObject cell(2, 3e-4);
    InternalForce force = kSoft;
    force.squeeze = 0.1 * pick(-100, 100);
    CooperativeMotion hold(cell.arms(true), {cell.path[0]}, {}, force);
    cell.move(hold.until(ElapsedSteps{150}));
    const Vector3d line = (cell.grasps[0].translation() - cell.grasps[1].translation()).normalized();
    const Vector3d felt = cell.grasps[0].linear() * cell.wrench(0).head<3>();
    RC_ASSERT((felt - force.squeeze * line).norm() < 0.2);
    RC_ASSERT(cell.wrench(0).tail<3>().norm() < 0.05);
    // no part of the tools' motion is a displacement of the object: the projection keeps all of it
    VectorXd moved(12), part(12);
    for (std::size_t i = 0; i < 2; ++i) {
      const Pose seen = cell.path[0].inverse() * cell.bases[i] * cell.team->members[i]->state.desired_pose;
      moved.segment<6>(static_cast<Eigen::Index>(6 * i)) << seen.translation() - cell.grasps[i].translation(),
          kSoft.length * rotation_vector(seen.linear() * cell.grasps[i].linear().transpose());
    }
    cell.internal.of(moved, part);
    RC_ASSERT((part - moved).norm() < 1e-5);
  });
}

TEST(CooperativeMotion, HoldsTheInternalForceDuringTheMotion) {
  check_property(30, [] {
    ElasticObject cell(pick(2, 3), 1e-4);
    CooperativeMotion motion(cell.arms(true), cell.path, {}, kSoft);
    cell.move(motion);
    RC_ASSERT(motion.internal_force() < 0.5);
    RC_ASSERT(way(motion.object(), cell.path.back()) < 1e-9);
  });
}

/// The steps until the path is near its end.
std::size_t random_step(const CooperativeMotion& motion) {
  return static_cast<std::size_t>(pick(1, static_cast<int>(motion.duration() / 0.02) - 1));
}

// each arm brakes on its own
TEST(CooperativeMotion, ContinuesAfterALateCommandWithoutAJump) {
  check_property(kCases, [] {
    ElasticObject cell(pick(2, 4));
    for (auto& member : cell.team->members) member->overrun = 0.001 * pick(0, 50);
    CooperativeMotion motion(cell.arms(false), cell.path);
    cell.team->members[0]->late_at = random_step(motion);
    RC_ASSERT(cell.move(motion.until(ElapsedSteps{20000})).ending == Ending::generator);
    const double step = cell.team->arms[0]->step_duration();
    for (const auto& member : cell.team->members) {
      const auto& commands = member->commands;
      const auto pause = std::find_if(commands.begin(), commands.end(),
                                      [](const RobotCommand& c) { return c.kind == CommandKind::hold; });
      RC_ASSERT(pause != commands.end());
      const auto again =
          std::find_if(pause, commands.end(), [](const RobotCommand& c) { return c.kind == CommandKind::pose; });
      RC_ASSERT(again->twist.head<3>().norm() < 0.02);  // from rest
      for (auto command = again + 1; command != commands.end(); ++command) {
        const Vector3d moved = command->pose.translation() - (command - 1)->pose.translation();
        RC_ASSERT((moved / step - 0.5 * (command->twist + (command - 1)->twist).head<3>()).norm() < 1e-3);
        RC_ASSERT((command->twist - (command - 1)->twist).head<3>().norm() < 1.0 * step);
      }
      RC_ASSERT(commands.back().twist.isZero(0));
    }
    RC_ASSERT(way(motion.object(), cell.path.back()) < 1e-9);
    RC_ASSERT(turn(motion.object(), cell.path.back()) < 1e-9);
    // the error of each arm is at most the difference of its stop from the others'
    RC_ASSERT(cell.misfit(cell.path.back()) < 0.05 * 0.3);
  });
}

TEST(CooperativeMotion, PauseStopsTheObjectOnItsPath) {
  check_property(kCases, [] {
    ElasticObject cell(pick(2, 4));
    CooperativeMotion motion(cell.arms(false), cell.path);
    const ObjectPath path(cell.path, {});
    cell.team->requests.assign(random_step(motion), OperatorRequest::none);
    cell.team->requests.insert(cell.team->requests.end(), static_cast<std::size_t>(pick(1, 200)),
                               OperatorRequest::pause);
    RC_ASSERT(cell.move(motion.until(ElapsedSteps{20000})).ending == Ending::generator);
    const auto& commands = cell.team->members[0]->commands;
    const double step = cell.team->arms[0]->step_duration();
    double along = 0;
    for (std::size_t k = 0; k < commands.size(); ++k) {
      if (commands[k].kind != CommandKind::pose) {
        RC_ASSERT(commands[k].kind == CommandKind::hold);
        RC_ASSERT(commands[k - 1].kind == CommandKind::hold || commands[k - 1].twist.isZero(0));
        continue;
      }
      const Pose object = cell.carried(0, k);
      for (std::size_t arm = 1; arm < cell.bases.size(); ++arm) RC_ASSERT(way(cell.carried(arm, k), object) < 1e-9);
      // on the path, and forward
      while (along < path.duration() && way(path.at(along + 1e-3), object) < way(path.at(along), object)) along += 1e-3;
      RC_ASSERT(way(path.at(along), object) < 2e-4);
      const bool goes_on = k > 0 && commands[k - 1].kind == CommandKind::pose;
      const Twist before = goes_on ? commands[k - 1].twist : Twist{Twist::Zero()};
      RC_ASSERT((commands[k].twist - before).head<3>().norm() < 1.0 * step);
    }
    RC_ASSERT(way(motion.object(), cell.path.back()) < 1e-9);
    RC_ASSERT(cell.misfit(cell.path.back()) < 1e-9);
  });
}

// an instruction that was ended in motion is followed by another one
TEST(CooperativeMotion, MovingArmsComeToRest) {
  check_property(kCases, [] {
    ElasticObject cell(2);
    std::vector<Twist> twists;
    for (auto& member : cell.team->members) {
      Twist twist;
      twist << random_vector(0.01), random_vector(0.01);
      member->state.desired_velocity = twist;
      twists.push_back(twist);
    }
    CooperativeMotion motion(cell.arms(false), {cell.path[0]});
    cell.move(motion.until(ElapsedSteps{40}));
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& commands = cell.team->members[i]->commands;
      RC_ASSERT((commands.front().twist - twists[i]).norm() < 0.4 * twists[i].norm() + 1e-9);
      RC_ASSERT(commands.back().twist.norm() < 1e-5);
      RC_ASSERT(way(commands.back().pose, commands.front().pose) < 0.002);
    }
  });
}

TEST(CooperativeMotion, ThrowsWhenTheInternalForceCannotBeHeld) {
  const auto code_of = [](ElasticObject& cell, const InternalForce& force) {
    CooperativeMotion hold(cell.arms(true), {cell.path[0]}, {}, force);
    try {
      cell.move(hold.until(ElapsedSteps{1000}));
    } catch (const NonFatalError& error) {
      return error.code();
    }
    return ErrorCode::none;
  };
  check_property(20, [&] {
    ElasticObject cell(2, 1e-4);
    InternalForce wanted = kSoft;
    RC_ASSERT(code_of(cell, wanted) == ErrorCode::none);
    wanted.squeeze = 30;
    wanted.limit = 20;  // it reaches 20 N before it is at 30 N
    RC_ASSERT(code_of(cell, wanted) == ErrorCode::force_limit);
  });
  check_property(20, [&] {
    ElasticObject cell(2, 1e-4);
    InternalForce wanted = kSoft;
    wanted.squeeze = 30;  // by 3 mm
    wanted.travel = 0.002;
    RC_ASSERT(code_of(cell, wanted) == ErrorCode::force_limit);
  });
}

TEST(CooperativeMotion, InvalidWrenchIsAnError) {
  check_property(5, [] {
    ElasticObject cell(2);
    auto arms = cell.arms(true);
    arms[1].wrench = [] { return Wrench(Wrench::Constant(kNan)); };
    CooperativeMotion hold(arms, {cell.path[0]});
    try {
      cell.move(hold);
      RC_FAIL("no error");
    } catch (const NonFatalError& error) {
      RC_ASSERT(error.code() == ErrorCode::sensor_not_ready);
    }
  });
}

TEST(CooperativeMotion, RefusesInvalidArguments) {
  fakes::FreeTeam team({Pose::Identity(), Pose::Identity()});
  const std::vector<Pose> path{Pose::Identity(), Pose(Eigen::Translation3d(1, 0, 0))};
  const CooperatingArm first{team.arms[0].get()}, second{team.arms[1].get()};
  const auto none = [] { return Wrench(Wrench::Zero()); };
  const auto make = [&](std::vector<CooperatingArm> arms, const InternalForce& force) {
    CooperativeMotion{std::move(arms), path, {}, force};
  };
  Pose bad = Pose::Identity();
  bad.linear() *= 2;
  EXPECT_NO_THROW(make({first, second}, {}));
  EXPECT_THROW(make({}, {}), NonFatalError);
  EXPECT_THROW(make({first, first}, {}), NonFatalError);
  EXPECT_THROW(make({first, {}}, {}), NonFatalError);
  EXPECT_THROW(make({{first.robot, bad}, second}, {}), NonFatalError);
  EXPECT_THROW(make({{first.robot, Pose::Identity(), none}, second}, {}), NonFatalError);
  EXPECT_THROW(make({first, second}, {.squeeze = kNan}), NonFatalError);
  EXPECT_THROW(make({first, second}, {.admittance = -1}), NonFatalError);
  EXPECT_THROW(make({first, second}, {.length = 0}), NonFatalError);
  EXPECT_THROW(make({first, second}, {.lag = 0}), NonFatalError);
  EXPECT_THROW(make({first, second}, {.travel = kNan}), NonFatalError);
  EXPECT_THROW(make({first, second}, {.limit = 0}), NonFatalError);
  EXPECT_THROW((CooperativeMotion{{first, second}, {}}), NonFatalError);

  CooperativeMotion alone({first}, path);
  EXPECT_THROW(Move({*team.arms[1]}, {}, alone), NonFatalError) << "its robot is not in the list and has no state";
  team.arms[1]->set_macrostep(20, 20);
  CooperativeMotion uneven({first, second}, path);
  EXPECT_THROW(Move(team.list(), {}, uneven), NonFatalError);
}

}  // namespace
}  // namespace mrroc::cooperative_motion_test
