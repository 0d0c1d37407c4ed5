#include "sensors/camera/pictures/hardware_camera.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>

#include "sensors/camera/keys.hpp"
#include "sensors/camera/pictures/live_camera.hpp"
#include "sensors/camera/pictures/played_video.hpp"
#include "vsp/make_source.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::vsp {

namespace {

void check_size(const config::SensorEntry& entry, const cv::VideoCapture& capture, const Intrinsics& intrinsics) {
  const auto width = static_cast<int>(capture.get(cv::CAP_PROP_FRAME_WIDTH));
  const auto height = static_cast<int>(capture.get(cv::CAP_PROP_FRAME_HEIGHT));
  if (width == intrinsics.width && height == intrinsics.height) return;
  refuse(entry, "width", "the pictures of \"" + text(entry, "device") + "\" have another size than width and height",
         std::to_string(width) + " and " + std::to_string(height));
}

/// In manual control, as V4L2 counts: 100 us.
bool expose(cv::VideoCapture& capture, double seconds) {
  constexpr double kManual = 1, kPerSecond = 1e4;
  return capture.set(cv::CAP_PROP_AUTO_EXPOSURE, kManual) && capture.set(cv::CAP_PROP_EXPOSURE, seconds * kPerSecond);
}

[[noreturn]] void refuse_device(const config::SensorEntry& entry, const std::string& device) {
  refuse(entry, "device", "\"" + device + "\" cannot be opened", "a camera's number or address, or a video file");
}

}  // namespace

HardwareCamera hardware_camera(const config::SensorEntry& entry) {
  const std::optional<Intrinsics> given = given_intrinsics(entry);
  if (!given) refuse(entry, "intrinsics", "missing", "fx, fy, cx, cy of this camera, px");
  if (number(entry, "field_of_view") > 0) refuse(entry, "field_of_view", "of a camera of hardware", "intrinsics alone");
  if (number(entry, "noise") > 0) refuse(entry, "noise", "added to a camera of hardware", "0");
  if (!text(entry, "camera").empty())
    refuse(entry, "camera", "of a camera of hardware", "source = 'simulated' beside it");
  HardwareCamera camera;
  camera.intrinsics = *given;
  const auto pose = mount_pose(entry);
  if (!pose && text(entry, "frame") != "camera") {
    refuse(entry, "position", "missing", "the camera's pose ('position', 'rotation'), or frame = 'camera'");
  }
  camera.mount = pose.value_or(Pose::Identity());
  return camera;
}

std::unique_ptr<PictureSource> open_device(const SourceContext& context, cv::Mat& picture) {
  const config::SensorEntry& entry = context.entry;
  HardwareCamera camera = hardware_camera(entry);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);  // our own message has all details
  const std::string& device = text(entry, "device");
  if (device.empty()) refuse(entry, "device", "missing", "a camera's number or address, or a video file");
  const std::filesystem::path file = context.deployment.file.parent_path() / device;
  auto capture = std::make_unique<cv::VideoCapture>();
  if (std::filesystem::is_regular_file(file)) {
    if (!capture->open(file.string())) refuse_device(entry, device);
    check_size(entry, *capture, camera.intrinsics);
    return std::make_unique<PlayedVideo>(std::move(capture), std::move(camera), context.servo_period, picture);
  }
  const bool number = std::all_of(device.begin(), device.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!(number && device.size() < 4 ? capture->open(std::stoi(device)) : capture->open(device))) {
    refuse_device(entry, device);
  }
  capture->set(cv::CAP_PROP_FRAME_WIDTH, camera.intrinsics.width);
  capture->set(cv::CAP_PROP_FRAME_HEIGHT, camera.intrinsics.height);
  check_size(entry, *capture, camera.intrinsics);
  const auto silent_after = static_cast<Tick>(std::ceil(kSilentAfter / context.servo_period));
  const std::shared_ptr<cv::VideoCapture> shared = std::move(capture);
  return std::make_unique<LiveCamera>([shared](cv::Mat& taken) { return shared->read(taken); },
                                      [shared](double seconds) { return expose(*shared, seconds); }, std::move(camera),
                                      silent_after, picture);
}

}  // namespace mrroc::vsp
