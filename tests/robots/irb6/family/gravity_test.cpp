#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <iostream>
#include <vector>

#include "robots/common/mjcf.hpp"
#include "robots/common/servo.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

/// The arm under gravity with its exact drives: (M + G^T J G) ddq + G^T b G dq + bias = G^T (k i).
class ArmUnderGravity {
 public:
  explicit ArmUnderGravity(const JointVector& joints) : mjcf_(robot_file("xml")) {
    mjcf_.set_joints(joints);
    for (int i = 0; i < robot().joint_count(); ++i) mjcf_.model->dof_armature[i] = mjcf_.model->dof_damping[i] = 0;
  }

  JointVector joints() const { return Eigen::Map<const Eigen::VectorXd>(mjcf_.data->qpos, robot().joint_count()); }

  void step(const JointVector& currents, double dt) {
    mj_forward(mjcf_.model.get(), mjcf_.data.get());
    const JointMatrix g = robot().transmission(joints());
    const JointMatrix inertia =
        mjcf_.mass_matrix() + g.transpose() * per_axis(&AxisParameters::rotor_inertia).asDiagonal() * g;
    const JointMatrix friction = g.transpose() * per_axis(&AxisParameters::viscous_friction).asDiagonal() * g;
    Eigen::Map<Eigen::VectorXd> speed(mjcf_.data->qvel, robot().joint_count()),
        position(mjcf_.data->qpos, robot().joint_count());
    const Eigen::Map<const Eigen::VectorXd> bias(mjcf_.data->qfrc_bias, robot().joint_count());
    const JointVector torque = g.transpose() * currents.cwiseProduct(per_axis(&AxisParameters::torque_constant));
    speed += dt * (inertia + dt * friction).llt().solve(torque - bias - friction * speed);  // friction implicit
    position += dt * speed;
  }

  /// Currents that hold the arm's weight at rest, A.
  JointVector holding_currents() {
    mj_forward(mjcf_.model.get(), mjcf_.data.get());
    const JointMatrix g = robot().transmission(joints());
    const JointVector bias = Eigen::Map<const Eigen::VectorXd>(mjcf_.data->qfrc_bias, robot().joint_count());
    const JointVector motor_torque = JointMatrix(g.transpose()).partialPivLu().solve(bias);
    return motor_torque.cwiseQuotient(per_axis(&AxisParameters::torque_constant));
  }

  void put(const JointVector& joints) { mjcf_.set_joints(joints); }

 private:
  Mjcf mjcf_;
};

// the brakes open at home with regulators at rest: the arm sags until their integral parts hold it
TEST(Gravity, OriginalRegulatorsHoldHome) {
  const JointVector home = robot().parameters().home;
  ArmUnderGravity arm(home);
  const JointVector holding = arm.holding_currents();
  JointVector start, motors, worst_motor = JointVector::Zero(robot().joint_count()),
                             worst_joint = JointVector::Zero(robot().joint_count());
  JointVector late_motor = JointVector::Zero(robot().joint_count()),
              peak_current = JointVector::Zero(robot().joint_count()), currents(robot().joint_count());
  ASSERT_EQ(robot().joints_to_motors(home, start), ErrorCode::none);
  std::vector<AxisServo> servos;
  for (int i = 0; i < robot().joint_count(); ++i)
    servos.emplace_back(robot().parameters().axes[static_cast<std::size_t>(i)], start[i]);
  constexpr int kTicks = 2500;
  for (int tick = 0; tick < kTicks; ++tick) {
    ASSERT_EQ(robot().joints_to_motors(arm.joints(), motors), ErrorCode::none);
    for (int i = 0; i < robot().joint_count(); ++i)
      currents[i] = servos[static_cast<std::size_t>(i)].current(start[i], motors[i]);
    arm.step(currents, kServoPeriod / 2);
    arm.step(currents, kServoPeriod / 2);
    worst_motor = worst_motor.cwiseMax((motors - start).cwiseAbs());
    worst_joint = worst_joint.cwiseMax((arm.joints() - home).cwiseAbs());
    peak_current = peak_current.cwiseMax(currents.cwiseAbs());
    if (tick > kTicks / 2) late_motor = late_motor.cwiseMax((motors - start).cwiseAbs());
  }
  for (int i = 0; i < robot().joint_count(); ++i) {
    const AxisParameters& axis = robot().parameters().axes[static_cast<std::size_t>(i)];
    std::printf("%-12s sag: motor %.1e rad, joint %.1e rad, after 2.5 s: motor %.1e rad; current %.2f A, peak %.2f A\n",
                axis.name.c_str(), worst_motor[i], worst_joint[i], late_motor[i], holding[i], peak_current[i]);
    EXPECT_LT(worst_motor[i], axis.following_error_max / 10) << axis.name;
    EXPECT_LT(late_motor[i], 2 * 2 * M_PI / axis.encoder_increments) << axis.name;
    EXPECT_LT(worst_joint[i], 1e-3) << axis.name;
    EXPECT_LT(peak_current[i], axis.current_max / 3) << axis.name;
  }
  EXPECT_GT(holding.cwiseAbs().maxCoeff(), 0.1) << "the arm has weight";
}

TEST(Gravity, DrivesHoldTheArmInEveryPostureAlsoAtFullSpeed) {
  constexpr std::uint64_t kSeed = 20060105;
  std::mt19937_64 random(kSeed);
  ArmUnderGravity arm(robot().parameters().home);
  const JointVector amperes_per_speed =
      per_axis(&AxisParameters::viscous_friction).cwiseQuotient(per_axis(&AxisParameters::torque_constant));
  JointVector worst = JointVector::Zero(robot().joint_count()), worst_moving = JointVector::Zero(robot().joint_count());
  for (int i = 0; i < 5000; ++i) {
    const JointVector posture = random_posture(random);
    arm.put(posture);
    const JointVector holding = arm.holding_currents().cwiseAbs();
    // every joint at full speed at once, in the worst combination of directions
    const JointVector speed = robot().transmission(posture).cwiseAbs() * per_axis(&AxisParameters::velocity_max);
    worst = worst.cwiseMax(holding);
    worst_moving = worst_moving.cwiseMax(holding + speed.cwiseProduct(amperes_per_speed));
  }
  std::cout << "seed " << kSeed << ", worst of 5000 postures, A: " << worst.transpose()
            << "\nand moving at full speed: " << worst_moving.transpose() << "\n";
  EXPECT_LT(worst.cwiseQuotient(per_axis(&AxisParameters::current_max)).maxCoeff(), 0.25);
  EXPECT_LT(worst_moving.cwiseQuotient(per_axis(&AxisParameters::current_max)).maxCoeff(), 1);
}

}  // namespace
}  // namespace mrroc
