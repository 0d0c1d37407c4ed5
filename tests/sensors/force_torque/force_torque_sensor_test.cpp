#include "sensors/force_torque/force_torque_sensor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "mrroc/errors.hpp"
#include "sensors/force_torque/made_sensor.hpp"

namespace mrroc::vsp::force_torque_sensor_test {
namespace {

/// A wrench within the default ranges.
Wrench any_wrench() {
  Wrench w;
  for (int i = 0; i < 6; ++i) w[i] = *rc::gen::inRange(-1000, 1001) * (i < 3 ? 0.1 : 0.01);
  return w;
}

Eigen::Matrix3d any_rotation() {
  Eigen::Vector3d axis{1.0 * *rc::gen::inRange(-10, 11), 1.0 * *rc::gen::inRange(-10, 11), 10.5};
  return Eigen::AngleAxisd(0.01 * *rc::gen::inRange(-314, 315), axis.normalized()).toRotationMatrix();
}

RobotState state_of(const Eigen::Matrix3d& orientation, bool synchronised = true) {
  RobotState state;
  state.pose.linear() = orientation;
  state.synchronised = synchronised;
  return state;
}

TEST(ForceTorqueSensor, ZeroIsTakenOutOfEveryReading) {
  ForceTorqueSensor sensor = made_sensor("zero = [1.0, -2.0, 3.0, 0.1, -0.2, 0.3]\n");
  Wrench zero;
  zero << 1, -2, 3, 0.1, -0.2, 0.3;
  const Wrench load = Wrench::Constant(0.5);
  EXPECT_TRUE(wrench_of(aggregated(sensor, raw_of(load + zero))).isApprox(load));
  EXPECT_TRUE(sensor.load(raw_of(load + zero)).isApprox(load)) << "of the EDP's force limits, too";
}

TEST(ForceTorqueSensor, WeightOfWhatItCarriesIsNoPartOfTheReadingInAnyPosture) {
  EXPECT_TRUE(rc::check([] {
    const std::string cutoff = std::to_string(*rc::gen::element(0, 5));
    ForceTorqueSensor sensor = made_sensor("tool_mass = 1.0\ncutoff = " + cutoff + ".0");
    const Load load{0.1 * *rc::gen::inRange(1, 30), {0.01 * *rc::gen::inRange(-9, 10), 0.02, 0.1}};
    const Eigen::Matrix3d first = any_rotation(), then = any_rotation();
    const auto supported = [&](const Eigen::Matrix3d& R) -> Wrench {
      return weight_of({1.0, Eigen::Vector3d::Zero()}, R) + weight_of(load, R);
    };
    sensor.effector_state(state_of(first));
    for (Tick tick = 0; tick < 10; ++tick) sensor.track(raw_of(supported(first), tick));
    RC_ASSERT((wrench_of(aggregated(sensor, raw_of(supported(first), 9))) - weight_of(load, first)).norm() < 1e-9);
    sensor.carry(load);
    RC_ASSERT(wrench_of(aggregated(sensor, raw_of(supported(first), 9))).norm() < 1e-9);  // the filter, too
    sensor.effector_state(state_of(then));
    RC_ASSERT(wrench_of(aggregated(sensor, raw_of(supported(then), 10))).norm() < 1e-9);
    sensor.carry({});
    RC_ASSERT((wrench_of(aggregated(sensor, raw_of(supported(then), 10))) - weight_of(load, then)).norm() < 1e-9);
  }));
}

TEST(ForceTorqueSensor, ReadsTheNegativeOfTheSupport) {
  EXPECT_TRUE(rc::check([] {
    ForceTorqueSensor sensor = made_sensor();
    const Wrench w = any_wrench();
    const SensorReading v = aggregated(sensor, raw_of(w));
    RC_ASSERT(v.error.error_class == ErrorClass::none);
    RC_ASSERT(wrench_of(v) == w);
  }));
}

TEST(ForceTorqueSensor, RawReadingOfTheBiasGivesZeroAndOthersTheDifference) {
  EXPECT_TRUE(rc::check([] {
    ForceTorqueSensor sensor = made_sensor(
        "force_noise = 0.3\ntorque_noise = 0.02\ncutoff = " + std::to_string(*rc::gen::element(0, 5, 250)) + ".0");
    const Tick tick = *rc::gen::inRange<Tick>(0, 1000);
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i)
      sensor.track(raw_of(any_wrench(), tick - std::min<Tick>(tick, 5)));
    const RawReading r = raw_of(any_wrench(), tick);
    RC_ASSERT(sensor.bias(r));
    RC_ASSERT(wrench_of(aggregated(sensor, r)) == Wrench::Zero());
    RC_ASSERT(sensor.bias(r));  // a repeated bias changes nothing
    RC_ASSERT(wrench_of(aggregated(sensor, r)) == Wrench::Zero());
  }));
  EXPECT_TRUE(rc::check([] {
    ForceTorqueSensor sensor = made_sensor();
    const Wrench zero = any_wrench(), load = any_wrench();
    sensor.bias(raw_of(zero));
    RC_ASSERT(wrench_of(aggregated(sensor, raw_of(load))) == load - zero);
  }));
}

TEST(ForceTorqueSensor, ReadingBeyondItsRangeIsAnErrorAndTheNextIsNot) {
  const Wrench limit{{130, 130, 400, 10, 10, 10}};
  for (int axis = 0; axis < 6; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      ForceTorqueSensor sensor = made_sensor();
      Wrench w = Wrench::Zero();
      w[axis] = sign * limit[axis];
      EXPECT_EQ(wrench_of(aggregated(sensor, raw_of(w, 1))), w) << "at the limit";
      Wrench beyond = w;
      beyond[axis] = std::nextafter(w[axis], sign * 1e9);
      const SensorReading v = aggregated(sensor, raw_of(beyond, 2));
      EXPECT_EQ(v.error.error_class, ErrorClass::non_fatal);
      EXPECT_EQ(v.error.code, ErrorCode::sensor_out_of_range);
      for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(std::isnan(v.values[i]));
      EXPECT_EQ(wrench_of(aggregated(sensor, raw_of(w, 3))), w) << "recovered";
    }
  }
}

TEST(ForceTorqueSensor, ErrorNamesAxisValueAndLimit) {
  ForceTorqueSensor sensor = made_sensor("force_range = [50.0, 50.0, 100.0]");
  const SensorReading v = aggregated(sensor, raw_of(Wrench{{0, 0, -123.5, 0, 0, 0}}));
  EXPECT_EQ(v.error.detail.view(), "force z -123.5 N, expected at most 100");
}

TEST(ForceTorqueSensor, BiasBeyondTheRangeKeepsTheZero) {
  ForceTorqueSensor sensor = made_sensor();
  const Wrench w{{1, 2, 3, 0.1, 0.2, 0.3}};
  sensor.bias(raw_of(w, 1));
  EXPECT_TRUE(sensor.bias(raw_of(Wrench{{500, 0, 0, 0, 0, 0}}, 2)));
  EXPECT_EQ(wrench_of(aggregated(sensor, raw_of(w, 3))), Wrench::Zero());
}

TEST(ForceTorqueSensor, CompensatesTheToolsWeightInEveryOrientation) {
  EXPECT_TRUE(rc::check([] {
    ForceTorqueSensor sensor = made_sensor("tool_mass = 0.6\ntool_centre = [0.01, -0.02, 0.08]");
    const Eigen::Matrix3d orientation = any_rotation();
    sensor.effector_state(state_of(orientation));
    const Wrench environment = 0.9 * any_wrench();
    Wrench weight;
    weight.head<3>() = orientation.transpose() * Eigen::Vector3d{0, 0, -0.6 * 9.81};
    weight.tail<3>() = Eigen::Vector3d{0.01, -0.02, 0.08}.cross(weight.head<3>().eval());
    const SensorReading v = aggregated(sensor, raw_of(environment + weight));
    RC_ASSERT(v.error.error_class == ErrorClass::none);
    RC_ASSERT((wrench_of(v) - environment).norm() < 1e-12);
  }));
}

TEST(ForceTorqueSensor, NeedsThePoseOfASynchronisedRobotForTheWeight) {
  ForceTorqueSensor sensor = made_sensor("tool_mass = 0.6");
  const RawReading r = raw_of(Wrench::Zero());
  EXPECT_EQ(aggregated(sensor, r).error.code, ErrorCode::sensor_not_ready);
  sensor.effector_state(state_of(Eigen::Matrix3d::Identity()));
  EXPECT_EQ(aggregated(sensor, r).error.code, ErrorCode::none);
  sensor.effector_state(state_of(Eigen::Matrix3d::Identity(), false));
  EXPECT_EQ(aggregated(sensor, r).error.code, ErrorCode::sensor_not_ready);
}

TEST(ForceTorqueSensor, RefusesParametersThatContradictEachOther) {
  EXPECT_THROW(made_sensor("cutoff = 251.0"), SystemError);
  EXPECT_NO_THROW(made_sensor("cutoff = 250.0"));
  config::SensorEntry entry = entry_of("force_torque", "wrist", "tool_mass = 1.0");
  entry.robot.clear();
  EXPECT_THROW(ForceTorqueSensor{}.set_up(entry, kServoPeriod), SystemError);
  entry.numbers.erase("gravity");
  EXPECT_THROW(ForceTorqueSensor{}.set_up(entry, kServoPeriod), SystemError);
}

}  // namespace
}  // namespace mrroc::vsp::force_torque_sensor_test
