#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <string>

#include "sensors/force_torque/made_sensor.hpp"

namespace mrroc::vsp::sign_test {
namespace {

/// A hand on a vertical slide; site "wrist" points its z axis down, the tool of 0.6 kg ends in a ball that is 0.05 m
/// off along x and 0.1 m below the site, above a table.
constexpr const char* kHand = R"(
<mujoco>
  <option timestep="0.001"/>
  <worldbody>
    <geom name="table" type="plane" size="1 1 0.1"/>
    <body name="hand" pos="0 0 0.15" euler="180 0 0">
      <joint name="slide" type="slide" axis="0 0 1" damping="200"/>
      <inertial pos="0 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>
      <body name="tool">
        <site name="wrist"/>
        <inertial pos="0 0 0.08" mass="0.6" diaginertia="0.001 0.001 0.001"/>
        <geom name="tip" type="sphere" size="0.01" pos="0.05 0 0.1" mass="0"/>
      </body>
    </body>
  </worldbody>
  <actuator><motor name="push" joint="slide"/></actuator>
  <sensor><force site="wrist"/><torque site="wrist"/></sensor>
</mujoco>)";

class Hand {
 public:
  Hand() : model_(load(), mj_deleteModel), data_(mj_makeData(model_.get()), mj_deleteData) {}

  /// Pushes down with `force` in addition to its own weight, for 2 s, until the hand is at rest. Returns the value that
  /// the simulator writes to the sensor's slot.
  RawReading push(double force) {
    data_->ctrl[0] = force - 1.6 * 9.81;
    for (int i = 0; i < 2000; ++i) mj_step(model_.get(), data_.get());
    RawReading r;
    r.tick = ++tick_;
    r.count = 6;
    std::copy_n(data_->sensordata, 6, r.values.begin());
    return r;
  }

 private:
  static mjModel* load() {
    std::array<char, 1000> error{};
    auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    const std::string text = kHand;
    mj_makeEmptyFileVFS(files.get(), "hand.xml", static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(), static_cast<char*>(files->filedata[0]));
    mjModel* model = mj_loadXML("hand.xml", files.get(), error.data(), static_cast<int>(error.size()));
    mj_deleteVFS(files.get());
    EXPECT_NE(model, nullptr) << error.data();
    return model;
  }

  std::unique_ptr<mjModel, void (*)(mjModel*)> model_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
  Tick tick_ = 0;
};

/// 20 N up (along -z of the tool), acting at (0.05, 0, 0.11): torque r x f = (0, 0.05 * 20, 0).
void expect_table(const SensorReading& v) {
  EXPECT_EQ(v.error.error_class, ErrorClass::none);
  const Wrench w = wrench_of(v);
  EXPECT_NEAR(w[2], -20, 0.01);
  EXPECT_NEAR(w[4], 1.0, 0.01);
  for (const int i : {0, 1, 3, 5}) EXPECT_NEAR(w[i], 0, 0.01) << i;
}

TEST(ForceTorqueSign, TableUnderAToolThatPointsDownPushesAlongMinusZ) {
  Hand hand;
  ForceTorqueSensor sensor = made_sensor();
  const RawReading free = hand.push(0);
  EXPECT_NEAR(wrench_of(aggregated(sensor, free))[2], 0.6 * 9.81, 0.01);  // the weight, along +z of the tool
  sensor.bias(free);
  expect_table(aggregated(sensor, hand.push(20)));
}

TEST(ForceTorqueSign, EqualWithTheToolsMassInsteadOfABias) {
  Hand hand;
  ForceTorqueSensor sensor = made_sensor("tool_mass = 0.6\ntool_centre = [0.0, 0.0, 0.08]");
  RobotState state;
  state.synchronised = true;
  state.pose.linear() = Eigen::AngleAxisd(3.14159265358979323846, Eigen::Vector3d::UnitX()).toRotationMatrix();
  sensor.effector_state(state);
  EXPECT_LT(wrench_of(aggregated(sensor, hand.push(0))).norm(), 0.01);
  expect_table(aggregated(sensor, hand.push(20)));
}

}  // namespace
}  // namespace mrroc::vsp::sign_test
