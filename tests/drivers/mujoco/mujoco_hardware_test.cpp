#include "drivers/mujoco/mujoco_hardware.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <memory>
#include <numbers>

#include "language/property.hpp"
#include "sim/bent_model.hpp"
#include "sim/mujoco_allocations.hpp"
#include "sim/reference_dynamics.hpp"
#include "sim/world.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim {
namespace {

using edp::HardwareInput;
using edp::MujocoHardware;
using Eigen::MatrixXd;
using Eigen::VectorXd;

JointVector pair(double a, double b) {
  JointVector vector(2);
  vector << a, b;
  return vector;
}

class MujocoHardwareTest : public testing::Test {
 protected:
  MujocoHardware hardware() { return {model_, *memory_, 3, MujocoHardware::Timing::lockstep}; }
  void measure(Tick tick, const JointVector& position, const JointVector& velocity) {
    world::JointMeasurement measurement{};
    measurement.tick = tick;
    for (std::size_t i = 0; i < 2; ++i) {
      measurement.position[i] = position[static_cast<Eigen::Index>(i)];
      measurement.velocity[i] = velocity[static_cast<Eigen::Index>(i)];
    }
    memory_->measurements[3].store(measurement);
  }
  world::JointDrive drive() const {
    world::JointDrive value;
    EXPECT_TRUE(memory_->drives[3].load(value));
    return value;
  }
  BentModel model_;
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
};

double joint_value() { return *rc::gen::inRange(-20000, 20000) * 1e-4; }

TEST_F(MujocoHardwareTest, ReadsShaftPositionsToHalfAnIncrement) {
  fakes::check_property(200, [&] {
    const JointVector joints = pair(joint_value(), joint_value());
    measure(7, joints, pair(0, 0));
    MujocoHardware drives = hardware();
    HardwareInput input;
    drives.read(7, input);
    RC_ASSERT(input.fault == ErrorCode::none && input.synchronised);
    JointVector exact;
    model_.joints_to_motors(joints, exact);
    for (Eigen::Index i = 0; i < 2; ++i) {
      const double increment =
          2 * std::numbers::pi / model_.parameters().axes[static_cast<std::size_t>(i)].encoder_increments;
      RC_ASSERT(std::abs(input.motors[i] - exact[i]) <= increment / 2 + 1e-12);
      RC_ASSERT(std::abs(std::remainder(input.motors[i], increment)) < 1e-10);
    }
  });
}

TEST_F(MujocoHardwareTest, WritesTheDrivesInJointCoordinates) {
  fakes::check_property(200, [&] {
    const JointVector q = pair(joint_value(), joint_value()), v = pair(joint_value(), joint_value());
    const JointVector current = pair(joint_value(), joint_value());
    measure(9, q, v);
    MujocoHardware drives = hardware();
    drives.enable(true);
    HardwareInput input;
    drives.read(9, input);
    drives.write(9, current);
    const world::JointDrive written = drive();
    RC_ASSERT(written.tick == 9U && written.enabled == 1U && written.joint_count == 2U);

    const MatrixXd g = model_.transmission(q), rate = model_.transmission_rate(q, v);
    const auto& axes = model_.parameters().axes;
    const MatrixXd inertia = VectorXd::Constant(2, axes[0].rotor_inertia).asDiagonal();
    const MatrixXd friction = VectorXd::Constant(2, axes[0].viscous_friction).asDiagonal();
    const MatrixXd torque_constants = (VectorXd(2) << 0.1, 0.11).finished().asDiagonal();
    const world::JointDrive expected =
        drive_of(g.transpose() * inertia * g, g.transpose() * friction * g, g.transpose() * torque_constants * current,
                 g.transpose() * inertia * rate * v);
    for (std::size_t i = 0; i < kMaxJoints; ++i) {
      RC_ASSERT(std::abs(written.torque[i] - expected.torque[i]) < 1e-10);
      RC_ASSERT(std::abs(written.bias[i] - expected.bias[i]) < 1e-6);
    }
    for (std::size_t i = 0; i < expected.rotor_inertia.size(); ++i) {
      RC_ASSERT(std::abs(written.rotor_inertia[i] - expected.rotor_inertia[i]) < 1e-10);
      RC_ASSERT(std::abs(written.damping[i] - expected.damping[i]) < 1e-10);
    }
  });
}

TEST_F(MujocoHardwareTest, CurrentsAreLimitedReportedAndZeroWhileDisabled) {
  measure(1, pair(0, 0), pair(0, 0));
  MujocoHardware drives = hardware();
  HardwareInput input;
  drives.read(1, input);
  drives.write(1, pair(50, -50));
  EXPECT_EQ(drive().enabled, 0U);
  EXPECT_EQ(drive().torque[0], 0.0);
  drives.enable(true);
  drives.write(1, pair(50, -50));
  EXPECT_EQ(drive().enabled, 1U);
  drives.read(1, input);
  EXPECT_EQ(input.current, pair(10, -10));
}

TEST_F(MujocoHardwareTest, OnlyTheCurrentTickIsFreshInLockstep) {
  MujocoHardware drives = hardware();
  HardwareInput input;
  drives.read(0, input);
  EXPECT_EQ(input.fault, ErrorCode::hardware_silent) << "nothing measured yet";
  measure(5, pair(1, 1), pair(0, 0));
  drives.read(5, input);
  EXPECT_EQ(input.fault, ErrorCode::none);
  const JointVector known = input.motors;
  measure(6, pair(2, 2), pair(0, 0));
  for (const Tick tick : {Tick{5}, Tick{7}}) {
    drives.read(tick, input);
    EXPECT_EQ(input.fault, ErrorCode::hardware_silent);
    EXPECT_EQ(input.motors, known) << "the last known motors";
  }
}

TEST_F(MujocoHardwareTest, JointsBeyondTheTransmissionAreADriveFault) {
  MujocoHardware drives = hardware();
  HardwareInput input;
  measure(1, pair(0, 11), pair(0, 0));
  drives.read(1, input);
  EXPECT_EQ(input.fault, ErrorCode::drive_fault);
}

TEST_F(MujocoHardwareTest, ServoTickDoesNotAllocate) {
  for (const auto timing : {MujocoHardware::Timing::lockstep, MujocoHardware::Timing::real}) {
    MujocoHardware drives{model_, *memory_, 3, timing};
    drives.enable(true);
    HardwareInput input;
    measure(1, pair(0.3, 0.2), pair(1, 2));
    const JointVector current = pair(1, 2);
    drives.read(1, input);
    const long before = test::allocations();
    EXPECT_GT(before, 0);
    for (int i = 0; i < 100; ++i) {
      drives.read(1, input);
      drives.write(1, current);
    }
    EXPECT_EQ(test::allocations() - before, 0);
  }
}

/// Largest change of the energy of links and rotors while the arm swings for a second with its drives without current;
/// `with_bias` = false omits c.
double energy_error(double period, bool with_bias) {
  BentModel model;
  model.take_friction_away();
  auto memory = std::make_unique<world::WorldMemory>();
  MujocoHardware drives(model, *memory, 0, MujocoHardware::Timing::lockstep);
  drives.enable(true);
  const auto composition = [] { return compose(kData / "empty.xml", {{"a", kTwolink, Pose::Identity(), false}}); };
  ReferenceDynamics energy(load_model(composition()), period);
  World world(composition(), period, period);
  world.attach("a", {"shoulder", "elbow"}, pair(1.0, 0.8));
  world.start();
  double initial = 0, worst = 0;
  for (Tick k = 1; k <= static_cast<Tick>(1.0 / period); ++k) {
    world::JointMeasurement measurement{};
    measurement.tick = k;
    world.measure(0, measurement);
    memory->measurements[0].store(measurement);
    const MatrixXd g = model.transmission(pair(measurement.position[0], measurement.position[1]));
    std::copy_n(world.data().qpos, 2, energy.data().qpos);
    std::copy_n(world.data().qvel, 2, energy.data().qvel);
    const double present = energy.energy(1.5e-4 * g.transpose() * g);
    if (k == 1) initial = present;
    worst = std::max(worst, std::abs(present - initial));
    HardwareInput input;
    drives.read(k, input);
    drives.write(k, pair(0, 0));
    world::JointDrive drive;
    memory->drives[0].load(drive);
    if (!with_bias) drive.bias = {};
    world.drive(0, drive, k);
    world.step(k);
  }
  return worst;
}

TEST(MujocoHardwareEnergy, IsKeptToFirstOrderWithAVariableTransmission) {
  const double coarse = energy_error(1e-3, true), fine = energy_error(1e-4, true);
  const double without_bias = energy_error(1e-4, false);
  std::cout << "energy error at 1 ms: " << coarse << " J, at 0.1 ms: " << fine
            << " J, at 0.1 ms without c: " << without_bias << " J\n";
  EXPECT_NEAR(coarse / fine, 10.0, 2.0);
  // without c the error is not that of the integration: it does not shrink with the step
  EXPECT_GT(without_bias, 20 * fine);
}

}  // namespace
}  // namespace mrroc::sim
