#include "cli/ros2/cameras/hardware_camera_topics.hpp"

namespace mrroc::cli {

HardwareCameraTopics::HardwareCameraTopics(ros2::Node& node, CameraViews& views, const std::string& name_space) {
  for (auto& [name, view] : views.hardware) topics_.push_back({view, {node, name_space, name}});
}

void HardwareCameraTopics::publish_new(std::int64_t now, const StampOf& stamp_of) {
  for (Topics& topics : topics_) {
    if (now < topics.next || !topics.view.has_new() || !topics.publisher.is_received()) continue;
    const std::optional<Tick> tick = topics.view.load(picture_);
    if (!tick) continue;
    topics.next = now + std::chrono::nanoseconds(CameraPublisher::kLeastInterval).count();
    topics.publisher.publish(topics.view.intrinsics(), picture_, stamp_of(*tick));
  }
}

}  // namespace mrroc::cli
