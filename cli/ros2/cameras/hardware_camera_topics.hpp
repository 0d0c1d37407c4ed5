#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <string>

#include "cli/pictures/camera_views.hpp"
#include "cli/ros2/cameras/camera_publisher.hpp"

namespace mrroc::cli {

/// The topics of a deployment's cameras of hardware: the pictures of readings while a node receives them. One
/// thread.
class HardwareCameraTopics {
 public:
  using StampOf = std::function<messages::builtin_interfaces::Time(Tick tick)>;

  /// `name_space`: of the topics. The node and `views` outlive it.
  HardwareCameraTopics(ros2::Node& node, CameraViews& views, const std::string& name_space);

  /// Publishes what is new. `now`: any clock, ns.
  void publish_new(std::int64_t now, const StampOf& stamp_of);

 private:
  struct Topics {
    HardwareView& view;
    CameraPublisher publisher;
    std::int64_t next = 0;  ///< when the next picture may be published
  };

  std::list<Topics> topics_;
  sim::Picture picture_;
};

}  // namespace mrroc::cli
