#include "cli/panel/camera_pictures.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/panel/world_event.hpp"
#include "sim/simulation.hpp"

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kNiceness = 10;  // the run's processes come first

std::shared_ptr<const CameraPicture> no_picture(std::string reason) {
  return std::make_shared<const CameraPicture>(CameraPicture{0, {}, std::move(reason)});
}

/// Sensor types that view the simulated world have this key.
bool is_camera(const config::SensorEntry& sensor) { return sensor.texts.contains("camera"); }

/// Why the pictures of this camera are not in the panel's reach; empty: they are drawn.
std::string obstacle_of(const config::Deployment& deployment, const config::SensorEntry& sensor) {
  if (sensor.source == "simulated" && deployment.sim) return "";
  return "source = '" + sensor.source + "': the panel shows pictures of simulated cameras only";
}

int whole_or_zero(const config::SensorEntry& sensor, const char* key) {
  const auto found = sensor.numbers.find(key);
  return found == sensor.numbers.end() || found->second.empty() ? 0 : static_cast<int>(found->second.front());
}

using Views = std::map<std::string, vsp::SimulatedView, std::less<>>;

/// One renderer for all cameras, as large as the largest picture. One thread.
class PictureDrawer {
 public:
  PictureDrawer(mjModel& model, const Views& views) {
    int width = 0, height = 0;
    for (const auto& [name, view] : views) {
      width = std::max(width, view.width);
      height = std::max(height, view.height);
    }
    try {
      renderer_.emplace(model, width, height, vsp::SimulatedView::kQuality);
    } catch (const std::exception& error) {  // a machine without OpenGL
      problem_ = error.what();
    }
  }

  /// The state of `event` seen by a camera.
  std::shared_ptr<const CameraPicture> draw(const vsp::SimulatedView& view, const std::string& event) try {
    if (!renderer_) return no_picture(problem_);
    const auto world = world_of_event(Json::parse(event, nullptr, false));
    if (!world || !renderer_->place(*world)) return no_picture("the run simulates another world");
    view.draw(*renderer_, pixels_);
    return std::make_shared<const CameraPicture>(CameraPicture{world->tick, sim::encode_png(pixels_), ""});
  } catch (const std::exception& error) {
    return no_picture(error.what());
  }

 private:
  std::optional<sim::Renderer> renderer_;
  std::string problem_;
  sim::Picture pixels_;
};

}  // namespace

CameraPictures::CameraPictures(const config::Deployment& deployment, std::chrono::seconds longest_wait)
    : longest_wait_(longest_wait) {
  for (const config::SensorEntry& sensor : deployment.sensors) {
    if (!is_camera(sensor)) continue;
    ShownCamera& camera = cameras_.emplace_back(ShownCamera{
        sensor.name, whole_or_zero(sensor, "width"), whole_or_zero(sensor, "height"), obstacle_of(deployment, sensor)});
    if (!camera.reason.empty()) continue;
    try {
      if (model_ == nullptr) model_ = sim::load_model(sim::compose(deployment));
      views_.emplace(sensor.name, vsp::view_of(*model_, sensor));
      pictures_[sensor.name];
    } catch (const std::exception& error) {
      camera.reason = error.what();
    }
  }
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
  if (views_.empty()) return;
  const std::lock_guard lock(mutex_);
  newest_ = event;
  if (++events_ == 1) arrived_.notify_all();
}

std::shared_ptr<const CameraPicture> CameraPictures::picture(std::string_view name) {
  const auto camera = std::find_if(cameras_.begin(), cameras_.end(), [&](const auto& c) { return c.name == name; });
  if (camera == cameras_.end()) return nullptr;
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
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);  // of this thread and those of OpenGL
  PictureDrawer drawer(*model_, views_);
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
    auto made = drawer.draw(views_.find(name)->second, event);
    lock.lock();
    drawn.picture = std::move(made);
    drawn.event = number;
    drawn_.notify_all();
  }
}

}  // namespace mrroc::cli
