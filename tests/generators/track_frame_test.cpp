#include "mrroc/generators/track_frame.hpp"

#include "generators/simulated_cell.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/move.hpp"

namespace mrroc::test::track_frame_test {
namespace {

/// A part on a belt that runs along y in front of the arm; a motor keeps the belt's speed constant.
constexpr const char* kBeltScene = R"(<mujoco><compiler angle="radian"/>
<worldbody>
  <body name="part" pos="0.75 -0.5 0.55">
    <joint name="belt" type="slide" axis="0 1 0"/>
    <geom name="part" type="box" size="0.03 0.03 0.02" mass="1"/>
  </body>
</worldbody>
<actuator><velocity name="drive" joint="belt" kv="50"/></actuator>
<sensor><jointpos name="encoder/travel" joint="belt"/><jointvel name="encoder/speed" joint="belt"/></sensor>
</mujoco>)";

struct Track : testing::TestWithParam<double> {};

TEST_P(Track, ToolStaysOnAPartOnTheBelt) {
  const double speed = GetParam();
  SimulatedCell cell(kBeltScene, {"encoder"});
  Irb6 arm(cell);
  RawSensor encoder(cell, "encoder");
  const Pose part = Irb6::tool_down(0.75, -0.5, -0.13);  // a frame on top of it, z down, at zero of the encoder
  const auto frame = [&]() -> std::optional<MovingFrame> {
    return sliding_frame(part, {0, 1, 0}, encoder.value(0), encoder.value(1), encoder.reading().tick);
  };
  Move({arm}, {encoder}, JointLine{arm, Irb6::tool_down(0.75, -0.3, 0.0)});
  cell.data().ctrl[0] = speed;
  Wait({arm}, {encoder}, When{"the part is there", [&] { return encoder.value(0) > 0.1; }});

  const Pose above = Pose(Eigen::Translation3d(0, 0, -0.1)), down = Pose(Eigen::Translation3d(0, 0, -0.01));
  double worst = 0, height = 0;
  bool counts = false;
  cell.on_tick = [&] {
    const Eigen::Vector3d error = cell.tool().translation() - cell.body("part").translation();
    if (counts) worst = std::max(worst, error.head<2>().norm());
    height = error.z();
  };
  const FrameLimits limits{.speed = 0.08, .acceleration = 0.2};  // of the wrist's pitch, going down
  TrackFrame catch_up(arm, frame, above, limits);
  const Outcome caught = Move({arm}, {encoder}, catch_up.until(ElapsedSteps{500}));
  EXPECT_EQ(caught.ending, Ending::generator);
  counts = true;
  TrackFrame work(arm, frame, {{down, 0.3}, {above, 0}}, limits);
  bool was_down = false;
  const Outcome worked = Move(
      {arm}, {encoder}, work.until(When{"", [&] {
                                          was_down = was_down || (work.point() == 0 && std::abs(height - 0.03) < 1e-3);
                                          return false;
                                        }}));
  EXPECT_EQ(worked.ending, Ending::generator);
  counts = false;
  std::printf("%.0f mm/s: caught up in %.2f s, down and up in %.2f s, at most %.2f mm from the part\n", 1000 * speed,
              caught.duration, worked.duration, 1000 * worst);
  EXPECT_TRUE(was_down);
  EXPECT_LT(worst, 1e-3);
  Move({arm}, {}, JointLine{arm, arm.parameters().home});  // from a motion
}

INSTANTIATE_TEST_SUITE_P(Speeds, Track, testing::Values(0.05, 0.1, 0.15));

}  // namespace
}  // namespace mrroc::test::track_frame_test
