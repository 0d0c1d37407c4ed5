// Force motions beside singularities, of every robot.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <random>

#include "edp/every_robot.hpp"
#include "edp/force/damped_inverse.hpp"
#include "force_rig.hpp"
#include "geometry/joint_motion.hpp"
#include "singular_postures.hpp"

namespace mrroc::edp::force_singularity_test {
namespace {

constexpr double kHalf = 0.5;

class OfEveryRobot : public testing::TestWithParam<KnownRobot> {
 protected:
  JointVector any_posture(std::mt19937& random) const {
    JointVector posture = model.parameters().home;
    for (Eigen::Index i = 0; i < posture.size(); ++i) {
      const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
      posture[i] = std::uniform_real_distribution<double>(std::max(axis.position_min, posture[i] - 3),
                                                          std::min(axis.position_max, posture[i] + 3))(random);
    }
    return posture;
  }
  static Twist any_twist(std::mt19937& random) {
    Twist twist;
    for (double& value : twist) value = std::uniform_real_distribution<double>(-0.1, 0.1)(random);
    return twist;
  }
  bool slim() const { return model.joint_count() - (model.kept_joint() >= 0 ? 1 : 0) < 6; }

  RobotModels models = GetParam().load(GetParam().file("toml"));
  const RobotModel& model = *models.front();
};

/// The bar: half of the way of 1 rad beside the singularity, or the state reports that about half is lost, or the
/// motion ends.
TEST_P(OfEveryRobot, ReportsLostMotion) {
  std::mt19937 random(7);
  int near = 0;
  for (const SingularPosture& singular : singular_postures(model, model.parameters().home)) {
    for (const double distance : {0.3, 0.1, 0.01, 1e-5, 0.0}) {
      for (int axis = 0; axis < 6; ++axis) {
        const double newtons = std::uniform_real_distribution<double>(axis < 3 ? 2 : 0.1, axis < 3 ? 20 : 1)(random);
        const double regular = std::abs(press(model, singular.at(1), axis, -newtons).way);
        for (const double sign : {-1.0, 1.0}) {
          SCOPED_TRACE(testing::Message() << "joint " << singular.joint << " distance " << distance << " axis " << axis
                                          << " force " << sign * newtons);
          const Pressing pressing = press(model, singular.at(distance), axis, sign * newtons);
          EXPECT_LE(pressing.speed, 1 + 1e-9);
          EXPECT_TRUE(-sign * pressing.way >= kHalf * regular || pressing.lost >= 0.4 ||
                      pressing.ended != ErrorCode::none)
              << pressing.way << " m of " << regular << ", lost " << pressing.lost;
          ++near;
        }
      }
    }
  }
  std::mt19937 postures(8);
  for (int i = 0; i < 100; ++i) {
    const int axis = i % 6;
    const double newtons = axis < 3 ? 10 : 0.5;
    const Pressing pressing = press(model, any_posture(postures), axis, newtons, 100);
    EXPECT_LE(pressing.speed, 1 + 1e-9);
  }
  RecordProperty("near", near);
}

TEST_P(OfEveryRobot, NothingIsDampedAwayFromSingularities) {
  std::mt19937 random(3);
  const ToolKinematics kinematics(model);
  const JointVector home = model.parameters().home;
  EXPECT_FALSE(damped_joint_velocity(kinematics, home, any_twist(random)).damped);
  for (int i = 0; i < 500; ++i) {
    const JointVector posture = any_posture(random);
    const Twist twist = any_twist(random);
    const DampedVelocity result = damped_joint_velocity(kinematics, posture, twist);
    if (!result.damped) {
      EXPECT_EQ(result.velocity, joint_velocity_of(kinematics, posture, twist)) << "bit for bit";
    }
  }
}

/// The joint velocities are continuous at the start of the damping and at the singularity.
TEST_P(OfEveryRobot, JointVelocitiesAreContinuous) {
  std::mt19937 random(4);
  const ToolKinematics kinematics(model);
  for (const SingularPosture& singular : singular_postures(model, model.parameters().home)) {
    const Twist any = any_twist(random);
    // with fewer joints only a twist that they can follow: at the singularity itself there is no unique one
    const Twist twist = slim() ? Twist(kinematics.jacobian(singular.at(0.5)).col(0) * 0.1) : any;
    constexpr double kStep = 2e-4;
    const auto velocity = [&](double distance) {
      return damped_joint_velocity(kinematics, singular.at(distance), twist).velocity;
    };
    int damped = 0;
    double worst = 0, largest = 0;
    for (double distance = slim() ? kStep : 0; distance < 0.5; distance += kStep) {
      worst = std::max(worst, (velocity(distance + kStep) - velocity(distance)).cwiseAbs().maxCoeff());
      largest = std::max(largest, velocity(distance).cwiseAbs().maxCoeff());
      damped += damped_joint_velocity(kinematics, singular.at(distance), twist).damped ? 1 : 0;
    }
    EXPECT_GT(damped, 10);
    EXPECT_LE(worst, 0.02 * largest) << "joint " << singular.joint << ", of " << largest;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, OfEveryRobot, testing::ValuesIn(every_robot()),
                         [](const auto& test) { return test.param.stem; });

/// An arm with six axes whose roll is nearly straight.
class WristRoll : public testing::TestWithParam<double> {};

TEST_P(WristRoll, ContactAxisMovesOnAndBack) {
  const RobotModels models = load_irb6(std::filesystem::path(MRROC_SOURCE_DIR) / "robots/irb6/irb6.toml");
  JointVector posture(6);
  posture << 0.2, -1.7, 0.2, 0.3, 1.0, 0.4;
  const double regular = press(*models.front(), posture, 2, -10).way;
  posture[4] = GetParam();
  const Pressing forwards = press(*models.front(), posture, 2, -10), back = press(*models.front(), posture, 2, 10);
  EXPECT_GE(forwards.way, kHalf * regular);
  EXPECT_LE(back.way, -kHalf * regular);
  EXPECT_GT(forwards.lost, 0) << "it is reported";
  EXPECT_EQ(forwards.ended, ErrorCode::none);
}

INSTANTIATE_TEST_SUITE_P(Of, WristRoll, testing::Values(0.2, 0.1, 0.03, 0.01, 1e-3, 1e-6, 0.0, -0.01, -0.1));

TEST(ForceSingularity, ContinuousLossEndsTheMotionAndTheNextOneWorks) {
  const RobotModels models = load_irb6(std::filesystem::path(MRROC_SOURCE_DIR) / "robots/irb6/irb6.toml");
  JointVector posture(6);
  posture << 0.2, -1.7, 0.2, 0.3, 0.001, 0.4;
  const Pressing turning =
      press(*models.front(), posture, 3, -0.5, 1000);  // about the direction that the wrist has lost
  EXPECT_EQ(turning.ended, ErrorCode::singular);
  EXPECT_GT(turning.lost, ForceMotion::kLostMost);
  const Pressing shorter = press(*models.front(), posture, 3, -0.5, static_cast<int>(ForceMotion::kLostTime / 0.002));
  EXPECT_EQ(shorter.ended, ErrorCode::none) << "only after its timeout";
  EXPECT_EQ(press(*models.front(), posture, 3, -0.005, 1000).ended, ErrorCode::none) << "below the relevant speed";
}

RobotCommand turning_about(int axis, double torque) {
  RobotCommand command;
  command.kind = CommandKind::force;
  for (int i = 0; i < 6; ++i) command.force.guarded(i);
  command.force.contact(axis, torque);
  return command;
}

TEST(ForceSingularity, InterruptedRobotStaysUsable) {
  ForceRig<Wrist> rig;
  rig.sensor.stiffness = 0;
  const RobotState first = rig.exchange(turning_about(3, -1));
  EXPECT_EQ(first.error.error_class, ErrorClass::none);
  EXPECT_GT(first.lost, 0.9);
  const RobotState end = rig.repeat(turning_about(3, -1), 100);
  EXPECT_EQ(end.error.error_class, ErrorClass::non_fatal);
  EXPECT_EQ(end.error.code, ErrorCode::singular) << end.error.detail.view();
  rig.run(200);
  EXPECT_TRUE(rig.seen().enabled());
  EXPECT_TRUE(rig.seen().desired.at_rest());
  EXPECT_EQ(rig.query().lost, 0) << "of a robot at rest";

  for (const double torque : {-1.0, 1.0}) {  // away and back
    const double before = rig.query().desired_joints[1];
    const RobotState across = rig.repeat(turning_about(4, torque), 20);
    EXPECT_EQ(across.error.error_class, ErrorClass::none) << across.error.detail.view();
    EXPECT_LT(torque * (across.desired_joints[1] - before), -0.01);
    rig.run(200);
  }
  EXPECT_EQ(rig.exchange(joint_command((JointVector(3) << 0.3, 0.5, 0).finished(), 2000, 2001)).error.error_class,
            ErrorClass::none);
}

}  // namespace
}  // namespace mrroc::edp::force_singularity_test
