#include "cli/panel/camera_pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cli/operator/watching/world_feed.hpp"
#include "cli/panel/scene.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "sensors/camera/pictures/simulated_camera.hpp"
#include "sim/simulation.hpp"

namespace mrroc::cli::camera_pictures_test {
namespace {

constexpr std::chrono::seconds kWait{120};  // a sanitizer makes pictures slow

/// The camera's demo with cameras of two sizes: one in the arm's hand, one beside the table.
config::Deployment two_cameras() {
  config::Deployment deployment = config::load_deployment(MRROC_SOURCE_DIR "/sensors/camera/demo.toml");
  for (config::SensorEntry& sensor : deployment.sensors)
    if (sensor.name == "lookout") sensor.numbers["width"] = {320}, sensor.numbers["height"] = {400};
  return deployment;
}

cv::Mat pixels_of(const CameraPicture& picture) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(picture.png.data());
  cv::Mat pixels;
  cv::cvtColor(cv::imdecode({bytes, static_cast<int>(picture.png.size())}, cv::IMREAD_COLOR), pixels,
               cv::COLOR_BGR2RGB);
  return pixels;
}

/// A deployment, its simulated world, and the events of it.
struct Seen {
  config::Deployment deployment = two_cameras();
  std::unique_ptr<world::WorldMemory> memory = std::make_unique<world::WorldMemory>();
  sim::Simulation simulation{deployment, *memory};
  WorldFeed feed{memory.get()};

  std::string event_of(Tick tick) {
    if (tick == 1) {
      simulation.publish_initial();
      feed.watch(true);
    }
    simulation.step(tick);
    return feed.take().value();
  }
};

TEST(CameraPicturesTest, PicturesAreThoseOfTheCamerasOwnProcess) {
  Seen seen;
  CameraPictures pictures(seen.deployment, {}, kWait);
  ASSERT_EQ(pictures.cameras().size(), 2U);
  for (Tick tick = 1; tick <= 3; ++tick) {
    pictures.take(seen.event_of(tick));
    for (std::size_t i = 0; i < seen.deployment.sensors.size(); ++i) {
      const config::SensorEntry& sensor = seen.deployment.sensors[i];
      EXPECT_EQ(pictures.cameras()[i].reason, "");
      const auto picture = pictures.picture(sensor.name);
      ASSERT_NE(picture, nullptr);
      EXPECT_EQ(picture->reason, "");
      EXPECT_EQ(picture->tick, tick);
      EXPECT_EQ(pictures.picture(sensor.name), picture) << "all browsers receive the same one";
      cv::Mat own;
      vsp::SimulatedCamera camera({seen.deployment, sensor, i, seen.memory.get(), 0.002}, own);
      vsp::RawReading raw;
      ASSERT_EQ(camera.read(tick, raw), vsp::SourceState::ready);
      const cv::Mat shown = pixels_of(*picture);
      ASSERT_EQ(shown.size(), own.size());
      EXPECT_EQ(cv::norm(shown, own, cv::NORM_L1), 0) << sensor.name << ", tick " << tick;
    }
  }
}

TEST(CameraPicturesTest, CamerasWithoutPicturesHaveAReason) {
  config::Deployment deployment = two_cameras();
  deployment.sensors[0].source = "hardware";
  deployment.sensors[1].texts["camera"] = "lokout";
  CameraPictures pictures(deployment);
  ASSERT_EQ(pictures.cameras().size(), 2U);
  EXPECT_NE(pictures.cameras()[0].reason.find("source = 'hardware'"), std::string::npos);
  EXPECT_NE(pictures.cameras()[1].reason.find("lokout"), std::string::npos);
  for (const ShownCamera& camera : pictures.cameras()) {
    const auto picture = pictures.picture(camera.name);
    ASSERT_NE(picture, nullptr);
    EXPECT_TRUE(picture->png.empty());
    EXPECT_EQ(picture->reason, camera.reason);
  }
  EXPECT_EQ(pictures.picture("third"), nullptr);
  const auto scene = nlohmann::json::parse(scene_json(nullptr, deployment, pictures.cameras()));
  EXPECT_EQ(scene.at("cameras").at(0).at("reason"), pictures.cameras()[0].reason);
  EXPECT_EQ(scene.at("cameras").at(1).at("width"), 320);
}

TEST(CameraPicturesTest, PicturesOfHardwareAreThoseOfItsNewestReading) {
  config::Deployment deployment = two_cameras();
  deployment.sensors[1].source = "hardware";
  ASSERT_EQ(deployment.sensors[1].name, "lookout");
  process::PictureMemory memory = process::PictureMemory::create(320, 400);
  const std::string file = "/proc/self/fd/" + std::to_string(memory.fd());
  CameraPictures pictures(deployment, {{"lookout", file}});
  EXPECT_EQ(pictures.cameras()[1].reason, "");
  EXPECT_EQ(pictures.picture("lookout")->reason, "the camera has made no reading yet");
  for (Tick tick = 5; tick < 8; ++tick) {
    std::vector<std::uint8_t> pixels(memory.bytes());
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(i / 7 + tick);
    memory.store(tick, pixels);
    const auto picture = pictures.picture("lookout");
    EXPECT_EQ(picture->tick, tick);
    EXPECT_EQ(pictures.picture("lookout"), picture) << "all browsers receive the same one";
    const cv::Mat shown = pixels_of(*picture);
    ASSERT_EQ(shown.size(), cv::Size(320, 400));
    EXPECT_TRUE(std::equal(pixels.begin(), pixels.end(), shown.data));
  }
  CameraPictures narrow(deployment, {{"lookout", "/dev/null"}});
  EXPECT_NE(narrow.cameras()[1].reason.find("is not such a memory"), std::string::npos) << narrow.cameras()[1].reason;
}

TEST(CameraPicturesTest, StatesOfAnotherWorldAreNotDrawn) {
  CameraPictures pictures(two_cameras(), {}, kWait);
  for (const char* event : {"", "{", "[]", R"({"event":"world"})", R"({"event":"world","tick":1,"positions":"all"})",
                            R"({"event":"world","tick":1,"positions":[1],"mocap_positions":[],"mocap_quaternions":[]})",
                            R"({"event":"world","positions":[],"mocap_positions":[1],"mocap_quaternions":[]})"}) {
    pictures.take(event);
    const auto picture = pictures.picture("eye");
    ASSERT_NE(picture, nullptr);
    EXPECT_TRUE(picture->png.empty());
    EXPECT_EQ(picture->reason, "the run simulates another world") << event;
  }
}

TEST(CameraPicturesTest, DeploymentsWithoutCamerasHaveNone) {
  CameraPictures pictures(config::load_deployment(MRROC_SOURCE_DIR "/tasks/press/press.toml"));
  EXPECT_TRUE(pictures.cameras().empty());
  EXPECT_EQ(pictures.picture("eye"), nullptr);
}

}  // namespace
}  // namespace mrroc::cli::camera_pictures_test
