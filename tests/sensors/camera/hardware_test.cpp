#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "sensors/camera/pictures/live_camera.hpp"
#include "sensors/camera/seen_world.hpp"

namespace mrroc::vsp::hardware_test {
namespace {

constexpr int kPictures = 20;
constexpr double kRate = 25;  // one picture in 20 ticks of 2 ms

/// A red disc that moves by 10 px per picture over a grey background.
void write_video(const std::filesystem::path& file) {
  cv::VideoWriter video(file.string(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), kRate, {320, 240});
  ASSERT_TRUE(video.isOpened());
  for (int i = 0; i < kPictures; ++i) {
    cv::Mat picture(240, 320, CV_8UC3, cv::Scalar(130, 130, 130));
    cv::circle(picture, {50 + 10 * i, 120}, 15, cv::Scalar(20, 20, 220), cv::FILLED, cv::LINE_AA);
    video.write(picture);
  }
}

const std::string kDeviceKeys =
    "source = 'hardware'\ndevice = 'disc.avi'\nwidth = 320\nheight = 240\nframe = 'camera'\n"
    "intrinsics = [400.0, 400.0, 160.0, 120.0]\nplane = [0.0, 0.0, 1.0]\n";

TEST(Video, IsPlayedInTheDeploymentsTime) {
  SeenWorld world("", kDeviceKeys);
  write_video(world.scratch().path() / "disc.avi");
  world.open();
  for (int i = 0; i < kPictures; i += 3) {
    for (const int within : {0, 7, 19}) {
      const SensorReading v = world.read(static_cast<Tick>(20 * i + within));
      ASSERT_TRUE(detected(v)) << i;
      EXPECT_EQ(v.tick, static_cast<Tick>(20 * i)) << "the picture's own tick";
      // plane at 1 m: x = (u - cx) / f; the codec moves edges by a fraction of a pixel
      EXPECT_NEAR(v.values[1], (50 + 10 * i - 160) / 400.0, 0.001);
      EXPECT_NEAR(v.values[2], 0, 0.001);
      EXPECT_NEAR(v.values[3], 1, 1e-9);
      EXPECT_NEAR(v.values[15], M_PI * 15.5 * 15.5 / 160000, 4e-4) << "area";
    }
  }
}

TEST(Video, IsSilentAtItsEnd) {
  SeenWorld world("", kDeviceKeys);
  write_video(world.scratch().path() / "disc.avi");
  world.open();
  world.read(20 * (kPictures - 1));
  EXPECT_EQ(world.state(), SourceState::ready);
  world.read(20 * kPictures);
  EXPECT_EQ(world.state(), SourceState::silent);
  world.read(20 * kPictures + 1);
  EXPECT_EQ(world.state(), SourceState::silent);
}

TEST(Video, RefusesAnotherSizeAndOtherFiles) {
  SeenWorld other("", kDeviceKeys + "debug_every = 2\n");
  other.scratch().write("disc.avi", "this is not a video");
  EXPECT_EQ(
      refusal([&] { other.open(); }),
      "sensors.eye.device: \"disc.avi\" cannot be opened, expected a camera's number or address, or a video file");
  std::string keys = kDeviceKeys;
  keys.replace(keys.find("320"), 3, "300");
  SeenWorld wide("", keys);
  write_video(wide.scratch().path() / "disc.avi");
  EXPECT_EQ(refusal([&] { wide.open(); }),
            "sensors.eye.width: the pictures of \"disc.avi\" have another size than width and height, expected 320 and "
            "240");
}

TEST(Video, DebugPicturesShowEveryNthReading) {
  task_test::ScratchFolder folder;
  const std::string debug = (folder.path() / "seen").string();
  SeenWorld world("", kDeviceKeys + "debug = '" + debug + "'\ndebug_every = 3\n");
  write_video(world.scratch().path() / "disc.avi");
  world.open();
  for (Tick i = 0; i < 7; ++i) world.read(20 * i);
  EXPECT_TRUE(std::filesystem::exists(debug + "/eye.toml"));
  for (const Tick tick : {0, 60, 120}) {
    std::string name = std::to_string(tick);
    name.insert(0, 8 - name.size(), '0');
    EXPECT_GT(std::filesystem::file_size(debug + "/eye_" + name + ".png"), 1000U) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(debug + "/eye_00000020.png"));
}

TEST(Video, RefusesAnUnwritableFolder) {
  task_test::ScratchFolder folder;
  const auto file = folder.write("file", "");
  SeenWorld world("", kDeviceKeys + "debug = '" + (file / "below").string() + "'\n");
  write_video(world.scratch().path() / "disc.avi");
  EXPECT_THROW(world.open(), SystemError);
}

/// A device that delivers pictures when the test requests them.
class Device {
 public:
  bool take(cv::Mat& picture) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return given_ > taken_ || ended_; });
    if (given_ == taken_) return false;
    ++taken_;
    picture = cv::Mat(240, 320, CV_8UC3, cv::Scalar(taken_, 0, 0));
    changed_.notify_all();
    return true;
  }
  void give() {
    const std::lock_guard lock(mutex_);
    ++given_;
    changed_.notify_all();
  }
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int given_ = 0, taken_ = 0;
  bool ended_ = false;
};

/// Reads at `tick` until `wanted` holds, for 5 s at most.
template <class Wanted>
bool becomes(LiveCamera& camera, Tick tick, RawReading& raw, Wanted wanted) {
  for (int i = 0; i < 5000; ++i) {
    if (wanted(camera.read(tick, raw))) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

TEST(LiveCamera, ReturnsTheNewestPictureAndNeverWaits) {
  Device device;
  cv::Mat picture;
  HardwareCamera hardware;
  hardware.intrinsics.width = 320;
  hardware.intrinsics.height = 240;
  {
    LiveCamera camera([&](cv::Mat& taken) { return device.take(taken); }, [](double) { return true; }, hardware, 100,
                      picture);
    RawReading raw;
    EXPECT_EQ(camera.read(10, raw), SourceState::not_ready);
    EXPECT_EQ(camera.read(110, raw), SourceState::not_ready);
    EXPECT_EQ(camera.read(111, raw), SourceState::silent) << "no picture for 100 ticks";
    device.give();
    ASSERT_TRUE(becomes(camera, 120, raw, [](SourceState state) { return state == SourceState::ready; }));
    EXPECT_EQ(raw.tick, 120U);
    EXPECT_EQ(raw.values[0], 1);
    EXPECT_EQ(picture.at<cv::Vec3b>(0, 0)[2], 1) << "RGB";
    EXPECT_EQ(camera.read(130, raw), SourceState::ready);
    EXPECT_EQ(raw.tick, 120U) << "still the first picture";
    device.give();
    ASSERT_TRUE(becomes(camera, 140, raw, [&](SourceState) { return raw.values[0] == 2; }));
    EXPECT_EQ(raw.tick, 140U);
    device.end();
    ASSERT_TRUE(becomes(camera, 150, raw, [](SourceState state) { return state == SourceState::silent; }));
  }
}

TEST(LiveCamera, ReadsNoPictureThatWasExposedBefore) {
  Device device;
  cv::Mat picture;
  HardwareCamera hardware;
  hardware.intrinsics.width = 320;
  hardware.intrinsics.height = 240;
  double exposure = 0;
  LiveCamera camera([&](cv::Mat& taken) { return device.take(taken); },
                    [&](double seconds) {
                      if (seconds > 1) return false;
                      exposure = seconds;
                      return true;
                    },
                    hardware, 1000, picture);
  RawReading raw;
  device.give();
  ASSERT_TRUE(becomes(camera, 1, raw, [](SourceState state) { return state == SourceState::ready; }));
  device.give();
  camera.expose(0.02);
  EXPECT_EQ(exposure, 0.02);
  EXPECT_EQ(camera.read(2, raw), SourceState::not_ready);
  for (std::uint64_t i = 0; i < LiveCamera::kQueued; ++i) device.give();
  device.give();
  ASSERT_TRUE(becomes(camera, 3, raw, [](SourceState state) { return state == SourceState::ready; }));
  EXPECT_EQ(raw.values[0], 3 + static_cast<double>(LiveCamera::kQueued));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 0)[2], 3 + static_cast<int>(LiveCamera::kQueued));
  device.give();
  EXPECT_THROW(camera.expose(5), NonFatalError);
  device.end();
  EXPECT_THROW(camera.expose(0.02), HardwareError);
}

}  // namespace
}  // namespace mrroc::vsp::hardware_test
