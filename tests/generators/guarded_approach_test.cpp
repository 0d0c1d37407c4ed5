#include "mrroc/generators/guarded_approach.hpp"

#include "generators/simulated_cell.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::test::guarded_approach_test {
namespace {

/// A range finder in the ground points up at the tool; its eye is 0.3 m below the tool's position at home.
constexpr const char* kWallScene = R"(<mujoco><compiler angle="radian"/>
<worldbody>
  <body name="gauge" pos="0.75 0 0.4"><geom type="sphere" size="0.005"/><site name="eye" zaxis="0 0 1" size="0.004"/></body>
</worldbody>
<sensor><rangefinder name="range" site="eye"/></sensor>
</mujoco>)";

TEST(GuardedApproachInSimulation, ArmStopsAtTheMeasuredDistance) {
  for (const double stop : {0.15, 0.2, 0.25}) {
    SimulatedCell cell(kWallScene, {"range"});
    Irb6 arm(cell);
    RawSensor range(cell, "range");
    double fastest = 0, nearest = 1;
    Eigen::Vector3d before = cell.tool().translation();
    cell.on_tick = [&] {
      const Eigen::Vector3d now = cell.tool().translation();
      fastest = std::max(fastest, (now - before).norm() / SimulatedCell::kPeriod);
      before = now;
      nearest = std::min(nearest, now.z() + 0.3);
    };
    const Outcome end =
        Move({arm}, {range},
             GuardedApproach{arm, [&] { return range.value(0); }, {0, 0, 1}, 0.05, stop}.until(ElapsedSteps{2000}));
    EXPECT_EQ(end.ending, Ending::generator);
    cell.run(250);
    std::printf("stop at %.0f mm: nearest %.2f mm, rests at %.2f mm after %.2f s\n", 1000 * stop, 1000 * nearest,
                1000 * (cell.tool().translation().z() + 0.3), end.duration);
    EXPECT_NEAR(cell.tool().translation().z() + 0.3, stop, 7e-4);
    EXPECT_GT(nearest, stop - 2e-4) << "the servo's own overshoot";
    EXPECT_GT(fastest, 0.045);
  }
}

}  // namespace
}  // namespace mrroc::test::guarded_approach_test
