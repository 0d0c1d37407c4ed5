#pragma once

#include <chrono>
#include <string>

#include "links/ros2/publisher.hpp"
#include "messages/builtin_interfaces/time.hpp"
#include "messages/sensor_msgs/camera_info.hpp"
#include "messages/sensor_msgs/image.hpp"
#include "sensors/camera/intrinsics.hpp"
#include "sim/rendering/picture.hpp"

namespace mrroc::cli {

/// K = (fx 0 cx; 0 fy cy; 0 0 1), P = (K 0), R = 1, and the distortion, which ROS 2 calls "plumb_bob". Without header.
messages::sensor_msgs::CameraInfo camera_info(const vsp::Intrinsics& camera);

/// The topics of a camera, `CAMERA/image_raw` and `CAMERA/camera_info`, in its frame CAMERA. One thread.
class CameraPublisher {
 public:
  static constexpr std::chrono::milliseconds kLeastInterval{100};  ///< between two pictures, of its users

  /// `name_space`: of the topics. The node outlives it.
  CameraPublisher(ros2::Node& node, const std::string& name_space, std::string camera);

  /// Whether a node receives its pictures. Any thread.
  bool is_received() const { return image_.is_received(); }
  void publish(const vsp::Intrinsics& camera, const sim::Picture& picture,
               const messages::builtin_interfaces::Time& stamp);

 private:
  std::string camera_;
  ros2::Publisher<messages::sensor_msgs::Image> image_;
  ros2::Publisher<messages::sensor_msgs::CameraInfo> info_;
};

}  // namespace mrroc::cli
