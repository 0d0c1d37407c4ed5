#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <vector>

#include "robots/common/mjcf.hpp"
#include "robots/common/servo.hpp"
#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc::gravity_test {
namespace {

JointVector gears() { return polycrank_model().transmission(polycrank_home()).diagonal(); }

/// The arm under gravity; MuJoCo's armature and damping are the drives, since every motor turns one joint only.
class ArmUnderGravity {
 public:
  explicit ArmUnderGravity(const JointVector& joints) : mjcf_(polycrank_source("polycrank.xml")) {
    mjcf_.set_joints(joints);
    mjcf_.model->opt.timestep = kServoPeriod / 2;
  }

  JointVector joints() const { return Eigen::Map<const Eigen::VectorXd>(mjcf_.data->qpos, 7); }

  void tick(const JointVector& currents) {
    const JointVector torque = currents.cwiseProduct(per_axis(&AxisParameters::torque_constant)).cwiseProduct(gears());
    for (int i = 0; i < 7; ++i) mjcf_.data->ctrl[i] = torque[i];
    mj_step(mjcf_.model.get(), mjcf_.data.get());
    mj_step(mjcf_.model.get(), mjcf_.data.get());
  }

  /// Currents that hold the arm's weight at rest, A.
  JointVector holding_currents() {
    mj_forward(mjcf_.model.get(), mjcf_.data.get());
    const JointVector bias = Eigen::Map<const Eigen::VectorXd>(mjcf_.data->qfrc_bias, 7);
    return bias.cwiseQuotient(gears()).cwiseQuotient(per_axis(&AxisParameters::torque_constant));
  }

  /// Contribution of the links to each rotor, kg m^2 at the shaft.
  JointVector load() const {
    const JointVector inertia = mjcf_.mass_matrix().diagonal();
    return inertia.cwiseQuotient(gears().cwiseAbs2()) - per_axis(&AxisParameters::rotor_inertia);
  }

  void put(const JointVector& joints) { mjcf_.set_joints(joints); }

 private:
  Mjcf mjcf_;
};

// the brakes open at home with regulators at rest: the arm sags until their integral parts hold it
TEST(PolycrankGravity, RegulatorsHoldHome) {
  const JointVector home = polycrank_home();
  ArmUnderGravity arm(home);
  const JointVector holding = arm.holding_currents();
  JointVector start, motors, worst_motor = JointVector::Zero(7), worst_joint = JointVector::Zero(7);
  JointVector late_motor = JointVector::Zero(7), peak_current = JointVector::Zero(7), currents(7);
  ASSERT_EQ(polycrank_model().joints_to_motors(home, start), ErrorCode::none);
  std::vector<AxisServo> servos;
  for (int i = 0; i < 7; ++i) {
    servos.emplace_back(polycrank_model().parameters().axes[static_cast<std::size_t>(i)], start[i]);
  }
  constexpr int kTicks = 2500;
  for (int tick = 0; tick < kTicks; ++tick) {
    ASSERT_EQ(polycrank_model().joints_to_motors(arm.joints(), motors), ErrorCode::none);
    for (int i = 0; i < 7; ++i) currents[i] = servos[static_cast<std::size_t>(i)].current(start[i], motors[i]);
    arm.tick(currents);
    worst_motor = worst_motor.cwiseMax((motors - start).cwiseAbs());
    worst_joint = worst_joint.cwiseMax((arm.joints() - home).cwiseAbs());
    peak_current = peak_current.cwiseMax(currents.cwiseAbs());
    if (tick > kTicks / 2) late_motor = late_motor.cwiseMax((motors - start).cwiseAbs());
  }
  for (int i = 0; i < 7; ++i) {
    const AxisParameters& axis = polycrank_model().parameters().axes[static_cast<std::size_t>(i)];
    std::printf("%-9s sag: motor %.1e rad, joint %.1e rad, after 2.5 s: motor %.1e rad; current %.2f A, peak %.2f A\n",
                axis.name.c_str(), worst_motor[i], worst_joint[i], late_motor[i], holding[i], peak_current[i]);
    EXPECT_LT(worst_motor[i], axis.following_error_max / 4) << axis.name;
    EXPECT_LT(late_motor[i], 2 * 2 * M_PI / axis.encoder_increments) << axis.name;
    EXPECT_LT(worst_joint[i], 5e-3) << axis.name;
    EXPECT_LT(peak_current[i], axis.current_max / 2) << axis.name;
  }
  EXPECT_GT(holding.cwiseAbs().maxCoeff(), 0.1) << "the arm has weight";
}

TEST(PolycrankGravity, DrivesHoldTheArmInEveryPostureAlsoAtFullSpeed) {
  constexpr std::uint64_t kSeed = 20110119;
  std::mt19937_64 random(kSeed);
  ArmUnderGravity arm(polycrank_home());
  const JointVector friction = gears()
                                   .cwiseProduct(per_axis(&AxisParameters::velocity_max))
                                   .cwiseProduct(per_axis(&AxisParameters::viscous_friction))
                                   .cwiseQuotient(per_axis(&AxisParameters::torque_constant));
  JointVector worst = JointVector::Zero(7), load = JointVector::Zero(7);
  for (int i = 0; i < 5000; ++i) {
    arm.put(random_joints(random, 0.5));
    worst = worst.cwiseMax(arm.holding_currents().cwiseAbs());
    load = load.cwiseMax(arm.load());
  }
  std::printf("seed %llu, worst of 5000 postures: %.1f %.1f %.1f %.2f %.2f %.2f %.2f A to hold\n",
              static_cast<unsigned long long>(kSeed), worst[0], worst[1], worst[2], worst[3], worst[4], worst[5],
              worst[6]);
  std::printf("and at full speed: %.1f %.1f %.1f %.2f %.2f %.2f %.2f A; links' inertia at most %.2f of the rotors'\n",
              worst[0] + friction[0], worst[1] + friction[1], worst[2] + friction[2], worst[3] + friction[3],
              worst[4] + friction[4], worst[5] + friction[5], worst[6] + friction[6],
              load.cwiseQuotient(per_axis(&AxisParameters::rotor_inertia)).maxCoeff());
  EXPECT_LT(load.cwiseQuotient(per_axis(&AxisParameters::rotor_inertia)).maxCoeff(), 3.2) << "servo_test's load";
  EXPECT_LT(worst.cwiseQuotient(per_axis(&AxisParameters::current_max)).maxCoeff(), 0.4);
  EXPECT_LT((worst + friction).cwiseQuotient(per_axis(&AxisParameters::current_max)).maxCoeff(), 0.95);
}

}  // namespace
}  // namespace mrroc::gravity_test
