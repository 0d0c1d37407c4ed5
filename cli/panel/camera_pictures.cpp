#include "cli/panel/camera_pictures.hpp"

#include <algorithm>
#include <utility>

#include "cli/pictures/picture_drawer.hpp"

namespace mrroc::cli {

namespace {

std::shared_ptr<const CameraPicture> no_picture(std::string reason) {
  return std::make_shared<const CameraPicture>(CameraPicture{0, {}, std::move(reason)});
}

std::shared_ptr<const CameraPicture> encoded(const DrawnPicture& drawn) try {
  if (!drawn.reason.empty()) return no_picture(drawn.reason);
  return std::make_shared<const CameraPicture>(CameraPicture{drawn.tick, sim::encode_png(drawn.pixels), ""});
} catch (const std::exception& error) {
  return no_picture(error.what());
}

}  // namespace

CameraPictures::CameraPictures(const config::Deployment& deployment, std::chrono::seconds longest_wait)
    : longest_wait_(longest_wait), views_(camera_views(deployment)) {
  for (const auto& [name, view] : views_.views) pictures_[name];
}

CameraPictures::~CameraPictures() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  asked_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void CameraPictures::take(const std::string& event) {
  if (views_.views.empty()) return;
  const std::lock_guard lock(mutex_);
  newest_ = event;
  if (++events_ == 1) arrived_.notify_all();
}

std::shared_ptr<const CameraPicture> CameraPictures::picture(std::string_view name) {
  const std::vector<ShownCamera>& all = views_.cameras;
  const auto camera = std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.name == name; });
  if (camera == all.end()) return nullptr;
  if (!camera->reason.empty()) return no_picture(camera->reason);
  std::unique_lock lock(mutex_);
  if (!arrived_.wait_for(lock, longest_wait_, [this] { return events_ > 0; }))
    return no_picture("the simulated world has sent no state yet");
  Drawn& drawn = pictures_.find(name)->second;
  if (drawn.event == events_) return drawn.picture;
  const std::uint64_t before = drawn.event;
  drawn.wanted = true;
  if (!thread_.joinable()) thread_ = std::thread([this] { draw_pictures(); });
  asked_.notify_one();
  if (!drawn_.wait_for(lock, longest_wait_, [&] { return drawn.event != before; }))
    return no_picture("a picture takes longer than " + std::to_string(longest_wait_.count()) + " s on this machine");
  return drawn.picture;
}

void CameraPictures::draw_pictures() {
  PictureDrawer drawer(views_);
  const auto wanted = [this] {
    return std::find_if(pictures_.begin(), pictures_.end(), [](const auto& entry) { return entry.second.wanted; });
  };
  std::unique_lock lock(mutex_);
  for (;;) {
    asked_.wait(lock, [&] { return ended_ || wanted() != pictures_.end(); });
    if (ended_) return;
    auto& [name, drawn] = *wanted();
    const std::string event = newest_;
    const std::uint64_t number = events_;
    drawn.wanted = false;
    lock.unlock();
    auto made = encoded(drawer.draw(views_.views.find(name)->second, event));
    lock.lock();
    drawn.picture = std::move(made);
    drawn.event = number;
    drawn_.notify_all();
  }
}

}  // namespace mrroc::cli
