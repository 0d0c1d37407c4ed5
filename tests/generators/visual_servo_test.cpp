#include "generators/simulated_cell.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/image_servo.hpp"
#include "mrroc/generators/position_servo.hpp"
#include "mrroc/move.hpp"

namespace mrroc::test::visual_servo_test {
namespace {

constexpr const char* kBareScene = R"(<mujoco><compiler angle="radian"/></mujoco>)";

/// A camera on the arm 50 mm beside its tool, and a target of four points below it. The image is computed from the
/// measured tool.
struct Servoing : testing::Test {
  Pose target_in_camera() const { return (cell.tool() * camera).inverse() * target; }
  ImagePoints image(const Pose& seen) const {
    ImagePoints points(2, 4);
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d p = seen * Eigen::Vector3d(i % 2 == 0 ? 0.08 : -0.08, i < 2 ? 0.08 : -0.08, 0);
      points.col(i) << p.x() / p.z(), p.y() / p.z();
    }
    return points;
  }
  void expect_there(const char* what, const Outcome& end) {
    EXPECT_EQ(end.ending, Ending::generator);
    cell.run(250);
    const Pose error = target_in_camera().inverse() * wanted;
    std::printf("%s: there in %.2f s, %.2f mm and %.2f mrad off\n", what, end.duration,
                1000 * error.translation().norm(), 1000 * rotation_vector(error.linear()).norm());
    EXPECT_LT(error.translation().norm(), 2e-3);
    EXPECT_LT(rotation_vector(error.linear()).norm(), 6e-3);
  }

  SimulatedCell cell{kBareScene};
  Irb6 arm{cell};
  const Pose camera = Pose(Eigen::Translation3d(0.05, 0, -0.05));
  const Pose target = Irb6::tool_down(0.8, 0.06, -0.35) * Pose(exp_rotation({0, 0, 0.2}));
  const Pose wanted = Pose(Eigen::Translation3d(0, 0, 0.4));
};

TEST_F(Servoing, PositionServoMovesTheArmOverTheTarget) {
  PositionServo servo(
      arm, [&] { return std::optional<Pose>(target_in_camera()); }, PositionServo::In::camera, camera * wanted, camera);
  expect_there("position", Move({arm}, {}, servo.until(ElapsedSteps{1500})));
}

TEST_F(Servoing, ImageServoMovesTheArmOverTheTarget) {
  ImageServo servo(
      arm, [&] { return std::optional<ImagePoints>(image(target_in_camera())); }, image(wanted),
      ImageDepths::Constant(1, 4, 0.4), camera);
  expect_there("image", Move({arm}, {}, servo.until(ElapsedSteps{1500})));
}

}  // namespace
}  // namespace mrroc::test::visual_servo_test
