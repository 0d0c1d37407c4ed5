#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <memory>

#include "config/table.hpp"
#include "geometry/rigid_motion.hpp"
#include "sim/errors/true_errors.hpp"
#include "sim/errors/truth_text.hpp"
#include "sim/reference_dynamics.hpp"
#include "sim/simulation.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::simulated_errors_test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;

/// A two-link arm in a world with errors. Its drives have 0.4 and 0.2 kg m^2 and rotors of 1.5e-4 kg m^2, so that its
/// largest torques are 1 N m sqrt(B / J).
class SimulatedErrors : public testing::Test {
 protected:
  SimulatedErrors() {
    setenv("MRROC_SHARE", kData.c_str(), 1);
    deployment_.sim->errors.emplace();
  }
  config::ErrorsEntry& errors() { return *deployment_.sim->errors; }
  static world::JointDrive push(Tick tick, const Vector2d& torque) {
    world::JointDrive drive =
        drive_of((MatrixXd(2, 2) << 0.4, 0, 0, 0.2).finished(), MatrixXd::Zero(2, 2), torque, Vector2d::Zero());
    drive.tick = tick;
    return drive;
  }
  world::JointMeasurement measurement() const {
    world::JointMeasurement value;
    EXPECT_TRUE(memory_->measurements[0].load(value));
    return value;
  }
  /// One tick under these torques.
  void step(Simulation& simulation, Tick tick, const Vector2d& torque) {
    memory_->drives[0].store(push(tick, torque));
    simulation.step(tick);
  }
  static double true_position(Simulation& simulation) {
    const mjModel& model = simulation.world().model();
    return simulation.world().data().qpos[model.jnt_qposadr[mj_name2id(&model, mjOBJ_JOINT, "a0/shoulder")]];
  }

  config::Deployment deployment_ = twolink_deployment(1);
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
};

TEST_F(SimulatedErrors, RobotStandsAtItsTrueBase) {
  errors().base_position = 0.01;
  errors().base_rotation = 0.02;
  Simulation simulation(deployment_, *memory_);
  const mjModel& model = simulation.world().model();
  const mjtNum* p = model.body_pos + 3 * mj_name2id(&model, mjOBJ_BODY, "a0");
  const Pose expected = deployment_.robots[0].base * error_of_base(errors(), "a0");
  EXPECT_LT((Eigen::Map<const Eigen::Vector3d>(p) - expected.translation()).norm(), 1e-12);
  EXPECT_GT((expected.translation() - deployment_.robots[0].base.translation()).norm(), 1e-4);
}

TEST_F(SimulatedErrors, LinksAreOffTheirPlaces) {
  Simulation exact(deployment_, *memory_);
  errors().link_position = 0.01;
  Simulation wrong(deployment_, *memory_);
  const auto tip = [](Simulation& simulation) {
    const mjModel& model = simulation.world().model();
    return Eigen::Vector3d(simulation.world().data().site_xpos + 3 * mj_name2id(&model, mjOBJ_SITE, "a0/wrist"));
  };
  const double moved = (tip(wrong) - tip(exact)).norm();
  EXPECT_GT(moved, 1e-4);
  EXPECT_LT(moved, 2 * std::sqrt(3) * 0.01);
}

TEST_F(SimulatedErrors, TruthIsWrittenAsItIsDrawn) {
  errors() = {.seed = 7, .base_position = 0.01, .link_rotation = 0.02, .joint_offset = 0.01, .force_bias = 1};
  Simulation simulation(deployment_, *memory_);
  const auto truth = config::Table::parse("errors.toml", truth_text(deployment_, simulation.world().model()));
  EXPECT_EQ(truth.integer_or("seed", 0, 0, 100), 7);
  const auto near = [](const std::vector<double>& found, const Eigen::Vector3d& drawn) {
    return (Eigen::Map<const Eigen::Vector3d>(found.data()) - drawn).norm() < 1e-8;
  };
  const config::Table robot = truth.table("robots").table("a0");
  EXPECT_TRUE(near(robot.numbers("base_position", 3), error_of_base(errors(), "a0").translation()));
  const config::Table links = robot.table("links");
  ASSERT_EQ(links.table_names().size(), 2U);
  for (const std::string& link : links.table_names()) {
    const Eigen::Vector3d turns = rpy_of(error_of_link(errors(), "a0", link).linear());
    EXPECT_GT(turns.norm(), 0);
    EXPECT_TRUE(near(links.table(link).numbers("rotation", 3), turns)) << link;
  }
  const config::Table shoulder = robot.table("joints").table("shoulder");
  EXPECT_NEAR(shoulder.number("offset"), errors_of_joint(errors(), "a0", "shoulder").offset, 1e-9);
  const auto wrist = std::find_if(deployment_.sensors.begin(), deployment_.sensors.end(),
                                  [](const config::SensorEntry& sensor) { return sensor.type == "force_torque"; });
  const auto bias = truth.table("sensors").table(wrist->name).numbers("bias", 6);
  EXPECT_NEAR(bias[2], error_of_wrench(errors(), wrist->name).bias[2], 1e-9);
}

TEST_F(SimulatedErrors, CamerasSeeAnOlderWorld) {
  config::SensorEntry& camera = deployment_.sensors.emplace_back();
  camera.name = "eye";
  camera.type = "camera";
  camera.texts["camera"] = "";
  for (const int latency : {0, 1, 7}) {
    errors().camera_latency = latency * deployment_.servo_period + 1e-9;
    Simulation simulation(deployment_, *memory_);
    const mjModel& model = simulation.world().model();
    const auto place = static_cast<std::size_t>(model.jnt_qposadr[mj_name2id(&model, mjOBJ_JOINT, "a0/shoulder")]);
    std::vector<double> shoulder;  // by tick
    world::WorldSnapshot present, seen;
    for (Tick tick = 0; tick <= 30; ++tick) {
      if (tick == 0)
        simulation.publish_initial();
      else
        step(simulation, tick, {2, -1});
      ASSERT_TRUE(memory_->snapshot.load(present));
      shoulder.push_back(present.values[place]);
      if (latency == 0) continue;
      ASSERT_TRUE(memory_->seen.load(seen));
      EXPECT_EQ(seen.tick, tick) << "a camera does not know that it is late";
      EXPECT_EQ(seen.values[place], shoulder[tick < Tick(latency) ? 0 : tick - Tick(latency)]);
    }
    EXPECT_NE(shoulder.front(), shoulder.back());
    EXPECT_EQ(memory_->seen.sequence() == 0, latency == 0);
  }
}

TEST_F(SimulatedErrors, EncodersReportTheTrueTransmission) {
  errors().joint_offset = 0.01;
  errors().gear_ratio = 0.02;
  errors().eccentricity = 0.005;
  Simulation simulation(deployment_, *memory_);
  simulation.publish_initial();
  for (Tick tick = 1; tick <= 200; ++tick) step(simulation, tick, {2, -1});
  const TrueJoint shoulder = errors_of_joint(errors(), "a0", "shoulder");
  EXPECT_NEAR(measurement().position[0], shoulder.reported(true_position(simulation)), 1e-12);
  EXPECT_GT(std::abs(measurement().position[0] - true_position(simulation)), 1e-4);
}

TEST_F(SimulatedErrors, EncoderTurnsThroughTheBacklashWhenTheJointTurnsBack) {
  errors().backlash = 0.01;
  Simulation simulation(deployment_, *memory_);
  simulation.publish_initial();
  const double backlash = errors_of_joint(errors(), "a0", "shoulder").backlash;
  const auto difference = [&] { return measurement().position[0] - true_position(simulation); };
  Tick tick = 0;
  while (tick < 400) step(simulation, ++tick, {60, 30});
  EXPECT_NEAR(difference(), backlash / 2, 1e-12);
  while (tick < 1200) step(simulation, ++tick, {-60, -30});
  EXPECT_NEAR(difference(), -backlash / 2, 1e-12);
}

TEST_F(SimulatedErrors, FrictionHoldsAJointUnderASmallTorque) {
  deployment_.robots[0].base = at(0, 0, 3) * Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitX());  // lies flat
  const auto turned = [this](double friction) {
    errors().friction = friction;
    Simulation simulation(deployment_, *memory_);
    simulation.publish_initial();
    for (Tick tick = 1; tick <= 250; ++tick) step(simulation, tick, {1.0, 0});
    return std::abs(true_position(simulation) - 0.5);
  };
  EXPECT_GT(turned(0), 0.05);
  EXPECT_LT(turned(0.5), 0.005);
}

TEST_F(SimulatedErrors, CurrentNoiseMovesARobotAndIsTheSameOnEveryRun) {
  const auto ends_at = [this](double noise) {
    errors().current_noise = noise;
    Simulation simulation(deployment_, *memory_);
    simulation.publish_initial();
    for (Tick tick = 1; tick <= 100; ++tick) step(simulation, tick, {0, 0});
    return true_position(simulation);
  };
  const double quiet = ends_at(0);
  EXPECT_NE(ends_at(0.01), quiet);
  EXPECT_EQ(ends_at(0.01), ends_at(0.01));
  EXPECT_EQ(ends_at(0), quiet);
}

TEST_F(SimulatedErrors, WrenchHasBiasAndDrift) {
  const auto force = [this](Tick ticks) {
    Simulation simulation(deployment_, *memory_);
    simulation.publish_initial();
    for (Tick tick = 1; tick <= ticks; ++tick) simulation.step(tick);
    RawReading reading;
    EXPECT_TRUE(memory_->readings[1].load(reading));
    return reading.values[0];
  };
  const double exact = force(100);
  errors().force_bias = 2;
  errors().force_drift = 0.5;
  const TrueWrench wrench = error_of_wrench(errors(), "wrist");
  EXPECT_NEAR(force(100) - exact, wrench.bias[0] + 0.2 * wrench.drift[0], 1e-9);
  EXPECT_GT(std::abs(wrench.bias[0]), 0.001);
}

TEST_F(SimulatedErrors, RangeNoiseNeverHidesAnObject) {
  errors().range_noise = 0.3;
  Simulation simulation(deployment_, *memory_);
  double least = 1, most = 0;
  for (Tick tick = 1; tick <= 300; ++tick) {
    simulation.step(tick);
    RawReading reading;
    ASSERT_TRUE(memory_->readings[0].load(reading));
    least = std::min(least, reading.values[0]);
    most = std::max(most, reading.values[0]);
  }
  EXPECT_GE(least, 0);
  EXPECT_GT(most - least, 0.5);
}

/// Sizes of 0 are no errors.
TEST_F(SimulatedErrors, ZeroSizesChangeNothing) {
  const auto run = [this] {
    Simulation simulation(deployment_, *memory_);
    simulation.publish_initial();
    for (Tick tick = 1; tick <= 300; ++tick) step(simulation, tick, {3, -2});
    return std::pair(true_position(simulation), measurement().position[1]);
  };
  const auto with_table = run();
  deployment_.sim->errors.reset();
  EXPECT_NEAR(run().first, with_table.first, 1e-12);
  EXPECT_NEAR(run().second, with_table.second, 1e-12);
}

}  // namespace
}  // namespace mrroc::sim::simulated_errors_test
