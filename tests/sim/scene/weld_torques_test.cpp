#include "sim/scene/weld_torques.hpp"

#include <cstdio>

#include "language/property.hpp"
#include "language/random_values.hpp"
#include "sim/world.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::weld_torques_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::random_vector;

constexpr int kCases = 40;
constexpr double kMass = 0.7;  // kg

std::string text(const Vector3d& v) {
  char line[96];
  std::snprintf(line, sizeof line, "%.9f %.9f %.9f", v.x(), v.y(), v.z());
  return line;
}

std::string text(const Eigen::Quaterniond& q) {
  char line[128];
  std::snprintf(line, sizeof line, "%.9f %.9f %.9f %.9f", q.w(), q.x(), q.y(), q.z());
  return line;
}

/// A fixed holder with force and torque sensors, and a load that a weld holds at `place` relative to it.
std::string scene(const Pose& holder, const Pose& place, bool holder_first) {
  const Pose load = holder * place;
  const Pose relative = holder_first ? place : place.inverse();
  const std::string names = holder_first ? R"(body1="holder" body2="load")" : R"(body1="load" body2="holder")";
  return R"(<mujoco><compiler angle="radian"/><worldbody><body name="holder" pos=")" + text(holder.translation()) +
         R"(" quat=")" + text(Eigen::Quaterniond(holder.linear())) +
         R"("><geom size="0.01" mass="0.2" contype="0" conaffinity="0"/><site name="wrist"/></body>)" +
         R"(<body name="load" pos=")" + text(load.translation()) + R"(" quat=")" +
         text(Eigen::Quaterniond(load.linear())) +
         R"("><freejoint/><geom type="box" size="0.05 0.03 0.02" mass="0.7" contype="0" conaffinity="0"/></body>)" +
         "</worldbody><equality><weld " + names + R"( solref="0.002 1" solimp="0.99 0.999 0.0001" relpose=")" +
         text(relative.translation()) + " " + text(Eigen::Quaterniond(relative.linear())) +
         R"("/></equality><sensor><force name="force" site="wrist"/><torque name="torque" site="wrist"/></sensor></mujoco>)";
}

TEST(WeldTorques, SensorMeasuresTheWeightAndItsTorqueThroughAWeld) {
  check_property(kCases, [] {
    const task_test::ScratchFolder scratch;
    const Pose holder = fakes::random_pose(0.5, 3), place = fakes::random_pose(0.3, 3);
    World world(compose_texts(scratch, scene(holder, place, *rc::gen::arbitrary<bool>())), 0.002, 0.001);
    world.start();
    for (Tick k = 1; k <= 500; ++k) world.step(k);
    const auto reading = [&](int i) {
      return Vector3d(holder.linear() * Eigen::Map<const Vector3d>(world.data().sensordata + 3 * i));
    };
    const double own = 0.2 * 9.81, load = kMass * 9.81;
    const Vector3d lever = holder.linear() * place.translation();
    RC_ASSERT((reading(0) - (own + load) * Vector3d::UnitZ()).norm() < 1e-3);
    RC_ASSERT((reading(1) - lever.cross(load * Vector3d::UnitZ())).norm() < 1e-3);
  });
}

}  // namespace
}  // namespace mrroc::sim::weld_torques_test
