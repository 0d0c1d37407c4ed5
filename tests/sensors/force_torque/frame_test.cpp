#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <memory>
#include <sstream>

#include "geometry/rigid_motion.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"
#include "mrroc/sensors/force_torque.hpp"
#include "sensors/force_torque/made_sensor.hpp"
#include "sensors/played_task.hpp"

namespace mrroc::frame_test {
namespace {

Eigen::Vector3d any_vector() {
  Eigen::Vector3d v;
  for (double& each : v) each = 0.01 * *rc::gen::inRange(-300, 301);
  return v;
}

Pose any_frame() { return pose_from_rpy(any_vector(), any_vector()); }

std::string text_of(const Eigen::Vector3d& v) {
  std::ostringstream text;
  text << "[" << v.x() << ", " << v.y() << ", " << v.z() << "]";
  return text.str();
}

/// A sensor with the reading `wrench`, and its task.
struct Reading {
  explicit Reading(const Wrench& wrench)
      : task(aggregating, "force_torque",
             "# mrroc readings support_force_x support_force_y support_force_z support_torque_x support_torque_y "
             "support_torque_z\n0 " +
                 line_of(-wrench)) {
    Wait({}, {wrist}, ElapsedSteps{1});
  }
  static std::string line_of(const Wrench& wrench) {
    std::string line;
    for (const double value : wrench) line += std::to_string(value) + " ";
    return line + "\n";
  }
  vsp::ForceTorqueSensor aggregating = vsp::made_sensor();
  vsp::PlayedTask task;
  ForceTorque wrist{task, "wrist"};
};

TEST(ForceTorqueFrame, ForceThroughTheFramesOriginHasNoTorqueThere) {
  // 20 N up at (0.05, 0, 0.11): r x f = (0, 1, 0) for f = -20 z
  const Reading reading(Wrench{{0, 0, -20, 0, 1, 0}});
  const Wrench tip = reading.wrist.in(pose_from_rpy({0.05, 0, 0.11}, {0, 0, 0}));
  EXPECT_LT((tip - Wrench{{0, 0, -20, 0, 0, 0}}).norm(), 1e-12);
  // turned about x by 180 degrees: the force is along the new z
  const Wrench turned = reading.wrist.in(pose_from_rpy({0.05, 0, 0.11}, {3.14159265358979323846, 0, 0}));
  EXPECT_LT((turned - Wrench{{0, 0, 20, 0, 0, 0}}).norm(), 1e-12);
}

TEST(ForceTorqueFrame, PowerIsTheSameInEveryFrame) {
  EXPECT_TRUE(rc::check([] {
    Wrench wrench;
    wrench << any_vector(), any_vector();
    const Reading reading(wrench);
    const Pose frame = any_frame();
    const Eigen::Vector3d velocity = any_vector(), rate = any_vector();  // of the sensor frame's origin, in its axes
    const Eigen::Matrix3d to_frame = frame.linear().transpose();
    Twist there;
    there << to_frame * (velocity + rate.cross(frame.translation())), to_frame * rate;
    const Wrench in = reading.wrist.in(frame);
    RC_ASSERT(std::abs(in.dot(there) - (wrench.head<3>().dot(velocity) + wrench.tail<3>().dot(rate))) < 1e-9);
    RC_ASSERT((reading.wrist.in(Pose::Identity()) - wrench).norm() < 1e-9);
  }));
}

// R of the sensor frame: from the tool's pose and the tool in use, not from the tool's own axes
TEST(ForceTorqueFrame, WeightIsCompensatedWithAnyToolAndAnyMount) {
  EXPECT_TRUE(rc::check([] {
    const Eigen::Vector3d turns = 0.4 * any_vector();
    vsp::ForceTorqueSensor sensor =
        vsp::made_sensor("tool_mass = 0.8\ntool_centre = [0.01, -0.02, 0.08]\nrotation = " + text_of(turns));
    RobotState state;
    state.synchronised = true;
    const Pose flange = any_frame();
    state.tool = any_frame();
    state.pose = flange * state.tool;
    sensor.effector_state(state);
    const Eigen::Matrix3d axes = flange.linear() * pose_from_rpy(Eigen::Vector3d::Zero(), turns).linear();
    Wrench weight;
    weight.head<3>() = axes.transpose() * Eigen::Vector3d{0, 0, -0.8 * 9.81};
    weight.tail<3>() = Eigen::Vector3d{0.01, -0.02, 0.08}.cross(weight.head<3>().eval());
    RC_ASSERT(vsp::wrench_of(vsp::aggregated(sensor, vsp::raw_of(weight))).norm() < 1e-5);
  }));
}

}  // namespace
}  // namespace mrroc::frame_test
