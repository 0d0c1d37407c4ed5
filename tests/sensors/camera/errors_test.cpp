// Simulated cameras in worlds with errors ([sim.errors]): the picture is that of the true camera.
#include <cmath>
#include <numbers>

#include "sensors/camera/pictures/faulty_camera.hpp"
#include "sensors/camera/seen_world.hpp"
#include "sim/errors/true_errors.hpp"

namespace mrroc::vsp::errors_test {
namespace {

/// A camera that looks down from 0.45 m, and a marker before it.
class CameraWithErrors : public ::testing::Test {
 protected:
  explicit CameraWithErrors()
      : world_(scene_of(std::string("<camera name='eye' pos='0 0 0.45' fovy='45'/>") + kMarker, marker_assets()),
               "detect = 'marker'\nmarker = 7\nmarker_size = 0.06\n") {}

  SensorReading look(const config::ErrorsEntry& errors) {
    world_.deployment().sim->errors = errors;
    world_.open();
    world_.place("marker", pose_from_rpy(kPlace, {0, 0, 0.3}));
    SensorReading v = world_.measure(1);
    EXPECT_TRUE(detected(v));
    return v;
  }

  /// The same, the marker being somewhere else now.
  SensorReading look_late(const config::ErrorsEntry& errors) {
    world_.deployment().sim->errors = errors;
    world_.open();
    world_.place("marker", pose_from_rpy(kPlace, {0, 0, 0.3}));
    world_.store_seen(1);
    world_.place("marker", pose_from_rpy(kPlace + Eigen::Vector3d(0.02, 0, 0), {0, 0, 0.3}));
    SensorReading v = world_.measure(1);
    EXPECT_TRUE(detected(v));
    return v;
  }

  static inline const Eigen::Vector3d kPlace{0.05, 0.03, 0.02};
  static inline const Pose kMount =
      Eigen::Translation3d(0, 0, 0.45) * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());

 private:
  SeenWorld world_;
};

TEST_F(CameraWithErrors, IsBesideItsMount) {
  config::ErrorsEntry errors;
  errors.seed = 5;
  errors.camera_position = 0.01;
  errors.camera_rotation = 0.02;
  const Pose error = sim::error_of_camera(errors, "eye");
  ASSERT_GT(error.translation().norm(), 0.001);
  const Eigen::Vector3d expected = kMount * ((kMount * error).inverse() * kPlace);
  EXPECT_GT((expected - kPlace).norm(), 0.002);
  EXPECT_LT((position_of(look(errors)) - expected).norm(), 0.0008);
}

TEST_F(CameraWithErrors, HasAnotherFocalLength) {
  config::ErrorsEntry errors;
  errors.seed = 2;
  errors.focal_length = 0.05;
  const double focal = sim::error_of_lens(errors, "eye").focal;
  ASSERT_GT(std::abs(focal), 0.005);
  const Eigen::Vector3d seen = kMount.inverse() * position_of(look(errors));
  const Eigen::Vector3d true_place = kMount.inverse() * kPlace;
  EXPECT_NEAR(seen.z(), true_place.z() / (1 + focal), 0.001) << "what is larger in the picture seems nearer";
}

TEST_F(CameraWithErrors, HasALens) {
  config::ErrorsEntry errors;
  errors.seed = 2;
  errors.distortion = 0.3;
  const double k1 = sim::error_of_lens(errors, "eye").k1;
  ASSERT_GT(std::abs(k1), 0.03);
  const SensorReading v = look(errors);
  const Eigen::Vector3d place = kMount.inverse() * kPlace;
  const Eigen::Vector2d ideal = place.head<2>() / place.z();
  const Intrinsics picture = Intrinsics::pinhole(640, 480, std::numbers::pi / 4);
  const Eigen::Vector2d shift = k1 * ideal.squaredNorm() * ideal * picture.fx;
  ASSERT_GT(shift.norm(), 0.3);
  const Eigen::Vector2d undistorted = picture.project(place);
  EXPECT_LT((Eigen::Vector2d(v.values[12], v.values[13]) - undistorted - shift).norm(), 0.4 * shift.norm() + 0.2);
}

TEST_F(CameraWithErrors, WithoutSizesIsTheNominalOne) { EXPECT_LT((position_of(look({})) - kPlace).norm(), 0.0005); }

// the demo's arm over its table, under its lamp
TEST(CameraWithShadows, LosesAPartOfTheLight) {
  setenv("MRROC_SHARE", MRROC_BINARY_DIR "/share/mrroc", 1);
  setenv("MRROC_PROGRAMS", MRROC_BINARY_DIR "/bin", 1);
  const config::Deployment deployment = config::load_deployment(MRROC_SOURCE_DIR "/sensors/camera/demo.toml");
  const sim::Model model = sim::load_model(sim::compose(deployment));
  SimulatedView view = view_of(*model, deployment.sensors[0]);
  view.camera.body = 0;
  view.camera.in_body =
      Eigen::Translation3d(0.5, 0, 2.5) * Pose(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
  sim::Renderer renderer(*model, view.width, view.height, SimulatedView::kQuality);
  world::WorldSnapshot home{};
  home.position_count = static_cast<std::uint32_t>(model->nq);
  home.mocap_count = static_cast<std::uint32_t>(model->nmocap);
  std::copy_n(model->qpos0, model->nq, home.values.data());
  ASSERT_TRUE(renderer.place(home));
  const auto picture = [&](double shadow) {
    sim::Picture drawn;
    FaultyCamera({.shadow = shadow}, "eye", view).draw(renderer, drawn);
    return drawn.pixels;
  };
  const auto light = picture(0), half = picture(0.5), dark = picture(1);
  EXPECT_EQ(light, picture(0)) << "the renderer's shadows stay off";
  std::size_t shaded = 0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    ASSERT_NEAR(half[i], (light[i] + dark[i]) / 2.0, 1) << i;
    if (light[i] > dark[i] + 20) ++shaded;
  }
  EXPECT_GT(shaded, light.size() / 500);
  EXPECT_LT(shaded, light.size() / 4);
}

TEST_F(CameraWithErrors, ThatIsLateShowsWhatIsStoredForIt) {
  config::ErrorsEntry errors;
  errors.camera_latency = 0.01;
  EXPECT_LT((position_of(look_late(errors)) - kPlace).norm(), 0.0005);
}

}  // namespace
}  // namespace mrroc::vsp::errors_test
