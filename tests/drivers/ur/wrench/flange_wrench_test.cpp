#include "drivers/ur/wrench/flange_wrench.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

namespace mrroc::ur::flange_wrench_test {
namespace {

using Eigen::Vector3d;

Wrench wrench(const Vector3d& force, const Vector3d& torque) { return (Wrench() << force, torque).finished(); }

/// A tool that points down: its z axis is -z of the base frame, its x axis that of the base.
WrenchPackage pointing_down(const Wrench& force, const Vector3d& offset = Vector3d::Zero()) {
  WrenchPackage package;
  package.force = force;
  package.offset = Pose(Eigen::Translation3d(offset));
  package.tool = Eigen::Translation3d(0.4, 0.1, 0.3) * Pose(Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()));
  return package;
}

TEST(FlangeWrench, ATableThatIsPressedPushesTheToolBack) {
  const Wrench load =
      load_on_sensor(pointing_down(wrench({0, 0, 20}, {0, 0, 0})), TorquePoint::flange, Pose::Identity());
  EXPECT_TRUE(load.isApprox(wrench({0, 0, -20}, {0, 0, 0}))) << load.transpose();
}

TEST(FlangeWrench, ACb3ReportsTorquesAboutTheTool) {
  // 10 N along x of the base at the tip, 0.2 m below the flange: no torque about the tip
  const WrenchPackage package = pointing_down(wrench({10, 0, 0}, {0, 0, 0}), {0, 0, 0.2});
  const Wrench load = load_on_sensor(package, TorquePoint::tool, Pose::Identity());
  EXPECT_TRUE(load.isApprox(wrench({10, 0, 0}, {0, 2, 0}))) << load.transpose();
}

TEST(FlangeWrench, TheSensorHasItsMount) {
  const Pose mount =
      Eigen::Translation3d(0, 0, 0.05) * Pose(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ()));
  const Wrench load = load_on_sensor(pointing_down(wrench({10, 0, 0}, {0, -2, 0})), TorquePoint::flange, mount);
  // about the sensor's origin 2 - 0.05 * 10 N m about y of the flange, which is x of the sensor
  EXPECT_TRUE(load.isApprox(wrench({0, -10, 0}, {1.5, 0, 0}), 1e-9)) << load.transpose();
}

/// The definition of the wrench of a force at a point, in both frames and with both points of the torque.
RC_GTEST_PROP(FlangeWrench, IsThatOfTheForcesOnTheTool, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) * 1e-3; };
  const auto vector = [&] { return Vector3d(number(), number(), number()); };
  const auto pose = [&] { return Pose(Eigen::Translation3d(vector()) * Pose(rotation_of(3 * vector()))); };
  const Pose flange = pose(), offset = pose(), mount = pose();
  const Vector3d force = vector(), point = vector();  // in the base frame
  for (const TorquePoint about : {TorquePoint::flange, TorquePoint::tool}) {
    WrenchPackage package;
    package.tool = flange * offset;
    package.offset = offset;
    const Vector3d origin = (about == TorquePoint::flange ? flange : package.tool).translation();
    package.force = wrench(force, (point - origin).cross(force));
    const Pose sensor = flange * mount;
    const Eigen::Matrix3d to_sensor = sensor.linear().transpose();
    const Wrench expected = wrench(to_sensor * force, to_sensor * (point - sensor.translation()).cross(force));
    RC_ASSERT((load_on_sensor(package, about, mount) - expected).norm() < 1e-9);
  }
}

TEST(FlangeWrench, ReadsItsFields) {
  const rtde::Vector6d force{1, 2, 3, 4, 5, 6}, pose{0.1, 0.2, 0.3, 0, 0, std::numbers::pi / 2}, offset{0, 0, 0.1};
  ASSERT_EQ(wrench_fields().size(), 4u);
  const auto package = read_wrench({1.5, force, pose, offset});
  ASSERT_TRUE(package);
  EXPECT_EQ(package->timestamp, 1.5);
  EXPECT_EQ(package->force[5], 6);
  EXPECT_TRUE((package->tool * Vector3d::UnitX()).isApprox(Vector3d(0.1, 1.2, 0.3)));
  EXPECT_FALSE(read_wrench({1.5, force, pose}));
  EXPECT_FALSE(read_wrench({1.5, force, pose, 1.0}));
}

}  // namespace
}  // namespace mrroc::ur::flange_wrench_test
