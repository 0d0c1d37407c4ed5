#include "cli/ros2/cameras/camera_topics.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "cli/ros2/robot_frames.hpp"

namespace mrroc::cli {

CameraTopics::CameraTopics(ros2::Node& node, const CameraViews& views, const std::string& name_space, std::string world)
    : world_(std::move(world)), views_(views) {
  for (const ShownCamera& camera : views_.cameras)
    if (!camera.reason.empty()) report(camera.name + ": " + camera.reason);
  for (const auto& [name, view] : views_.views) topics_.try_emplace(name, node, name_space, name);
  if (topics_.empty()) return;
  tf_.emplace(node, "/tf");
  thread_ = std::thread([this] { draw_pictures(); });
}

CameraTopics::~CameraTopics() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void CameraTopics::take(const std::string& event, const messages::builtin_interfaces::Time& stamp) {
  if (topics_.empty()) return;
  const std::lock_guard lock(mutex_);
  newest_ = {event, stamp, newest_.number + 1};
  changed_.notify_all();
}

std::optional<std::string> CameraTopics::take_problem() {
  const std::lock_guard lock(mutex_);
  for (auto& [problem, taken] : problems_)
    if (!std::exchange(taken, true)) return problem;
  return std::nullopt;
}

void CameraTopics::report(const std::string& problem) {
  const std::lock_guard lock(mutex_);
  problems_.try_emplace(problem, false);
}

bool CameraTopics::is_received() const {
  return std::any_of(topics_.begin(), topics_.end(), [](const auto& entry) { return entry.second.is_received(); });
}

void CameraTopics::draw_pictures() {
  std::optional<PictureDrawer> drawer;  // OpenGL is loaded for the first picture that a node receives
  std::uint64_t drawn = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return ended_ || newest_.number != drawn; });
    if (ended_) return;
    const World world = newest_;
    drawn = world.number;
    lock.unlock();
    if (is_received()) {
      if (!drawer) drawer.emplace(views_);
      for (const auto& [name, topics] : topics_)
        if (topics.is_received())
          publish(name, drawer->draw(views_.views.find(name)->second, world.event), world.stamp);
    }
    lock.lock();
    changed_.wait_for(lock, CameraPublisher::kLeastInterval, [&] { return ended_; });
  }
}

void CameraTopics::publish(const std::string& camera, const DrawnPicture& drawn,
                           const messages::builtin_interfaces::Time& stamp) {
  if (!drawn.reason.empty()) return report(camera + ": " + drawn.reason);
  const vsp::SimulatedView& view = views_.views.find(camera)->second;
  messages::tf2_msgs::TFMessage frame;
  frame.transforms.push_back(transform_of(world_, camera, drawn.camera));
  frame.transforms.back().header.stamp = stamp;
  tf_->publish(frame);
  topics_.at(camera).publish(vsp::Intrinsics::pinhole(view.width, view.height, view.field_of_view), drawn.pixels,
                             stamp);
}

}  // namespace mrroc::cli
