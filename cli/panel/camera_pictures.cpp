#include "cli/panel/camera_pictures.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "cli/pictures/picture_drawer.hpp"

namespace mrroc::cli {

namespace {

std::shared_ptr<const CameraPicture> no_picture(std::string reason) {
  return std::make_shared<const CameraPicture>(CameraPicture{0, {}, std::move(reason)});
}

std::shared_ptr<const CameraPicture> encoded(Tick tick, const sim::Picture& pixels) try {
  return std::make_shared<const CameraPicture>(CameraPicture{tick, sim::encode_png(pixels), ""});
} catch (const std::exception& error) {
  return no_picture(error.what());
}

}  // namespace

CameraPictures::CameraPictures(const config::Deployment& deployment, const std::map<std::string, std::string>& files,
                               std::chrono::seconds longest_wait)
    : longest_wait_(longest_wait), views_(camera_views(deployment, files)) {
  for (const ShownCamera& camera : views_.cameras) pictures_[camera.name];
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
  const auto hardware = views_.hardware.find(name);
  return hardware == views_.hardware.end() ? drawn_picture(name) : hardware_picture(name, hardware->second);
}

std::shared_ptr<const CameraPicture> CameraPictures::hardware_picture(std::string_view name, HardwareView& view) {
  const std::lock_guard lock(mutex_);
  auto& shown = pictures_.find(name)->second.picture;
  if (shown != nullptr && !view.has_new()) return shown;
  sim::Picture pixels;
  const std::optional<Tick> tick = view.load(pixels);
  if (!tick) return shown != nullptr ? shown : no_picture("the camera has made no reading yet");
  return shown = encoded(*tick, pixels);
}

std::shared_ptr<const CameraPicture> CameraPictures::drawn_picture(std::string_view name) {
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
    const DrawnPicture seen = drawer.draw(views_.views.find(name)->second, event);
    auto made = seen.reason.empty() ? encoded(seen.tick, seen.pixels) : no_picture(seen.reason);
    lock.lock();
    drawn.picture = std::move(made);
    drawn.event = number;
    drawn_.notify_all();
  }
}

}  // namespace mrroc::cli
