#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "cli/pictures/camera_views.hpp"
#include "cli/pictures/picture_drawer.hpp"
#include "cli/ros2/cameras/camera_publisher.hpp"
#include "links/ros2/publisher.hpp"
#include "messages/tf2_msgs/tf_message.hpp"

namespace mrroc::cli {

/// The topics of a deployment's simulated cameras, and their frames in the world. A picture is drawn from the run's
/// newest event "world" in a thread of its own, and only while a node receives pictures of that camera.
class CameraTopics {
 public:
  /// `name_space`: of the topics; `world`: name of the world's frame. `views` and the node outlive it; the thread uses
  /// them.
  CameraTopics(ros2::Node& node, const CameraViews& views, const std::string& name_space, std::string world);
  ~CameraTopics();
  CameraTopics(const CameraTopics&) = delete;
  CameraTopics& operator=(const CameraTopics&) = delete;

  /// Whether this sensor is one of them. Any thread.
  bool has(const std::string& sensor) const { return topics_.contains(sensor); }
  /// Takes the run's newest event "world"; it draws nothing. One thread.
  void take(const std::string& event, const messages::builtin_interfaces::Time& stamp);
  /// Why a camera has no pictures, once for each reason. One thread.
  std::optional<std::string> take_problem();

 private:
  struct World {
    std::string event;
    messages::builtin_interfaces::Time stamp;
    std::uint64_t number = 0;  ///< counts them
  };

  void draw_pictures();
  bool is_received() const;
  void publish(const std::string& camera, const DrawnPicture& drawn, const messages::builtin_interfaces::Time& stamp);
  void report(const std::string& problem);

  const std::string world_;
  const CameraViews& views_;
  std::map<std::string, CameraPublisher> topics_;
  std::optional<ros2::Publisher<messages::tf2_msgs::TFMessage>> tf_;
  std::mutex mutex_;
  std::condition_variable changed_;
  World newest_;
  std::map<std::string, bool> problems_;  ///< whether they have been taken
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace mrroc::cli
