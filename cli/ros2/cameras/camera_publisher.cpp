#include "cli/ros2/cameras/camera_publisher.hpp"

#include <utility>

#include "links/ros2/ros_names.hpp"

namespace mrroc::cli {

messages::sensor_msgs::CameraInfo camera_info(const vsp::Intrinsics& camera) {
  messages::sensor_msgs::CameraInfo info;
  info.width = static_cast<std::uint32_t>(camera.width);
  info.height = static_cast<std::uint32_t>(camera.height);
  info.distortion_model = "plumb_bob";
  info.d.assign(camera.distortion.begin(), camera.distortion.end());
  info.k = {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  info.r = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.p = {camera.fx, 0, camera.cx, 0, 0, camera.fy, camera.cy, 0, 0, 0, 1, 0};
  return info;
}

CameraPublisher::CameraPublisher(ros2::Node& node, const std::string& name_space, std::string camera)
    : camera_(std::move(camera)),
      image_(node, ros2::in_namespace(ros2::in_namespace(name_space, camera_), "image_raw")),
      info_(node, ros2::in_namespace(ros2::in_namespace(name_space, camera_), "camera_info")) {}

void CameraPublisher::publish(const vsp::Intrinsics& camera, const sim::Picture& picture,
                              const messages::builtin_interfaces::Time& stamp) {
  messages::sensor_msgs::CameraInfo info = camera_info(camera);
  info.header.stamp = stamp;
  info.header.frame_id = camera_;
  info_.publish(info);
  messages::sensor_msgs::Image image;
  image.header = info.header;
  image.width = info.width;
  image.height = info.height;
  image.encoding = "rgb8";
  image.step = 3 * image.width;
  image.data = picture.pixels;
  image_.publish(image);
}

}  // namespace mrroc::cli
