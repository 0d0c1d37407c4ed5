#include "cli/pictures/picture_drawer.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>

#include "cli/pictures/world_event.hpp"

namespace mrroc::cli {

namespace {

constexpr int kNiceness = 10;

}  // namespace

PictureDrawer::PictureDrawer(const CameraViews& views) {
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);  // of this thread and those that it starts
  int width = 0, height = 0;
  for (const auto& [name, view] : views.views) {
    width = std::max(width, view.width);
    height = std::max(height, view.height);
  }
  try {
    renderer_.emplace(*views.model, width, height, vsp::SimulatedView::kQuality);
  } catch (const std::exception& error) {  // a machine without OpenGL
    problem_ = error.what();
  }
}

DrawnPicture PictureDrawer::draw(const vsp::SimulatedView& view, const std::string& event) noexcept {
  DrawnPicture drawn;
  try {
    const auto world = world_of_event(nlohmann::ordered_json::parse(event, nullptr, false));
    if (!renderer_) {
      drawn.reason = problem_;
    } else if (!world || !renderer_->place(*world)) {
      drawn.reason = "the run simulates another world";
    } else {
      drawn.tick = world->tick;
      drawn.camera = renderer_->body_pose(view.camera.body) * view.camera.in_body;
      view.draw(*renderer_, drawn.pixels);
    }
  } catch (const std::exception& error) {
    drawn.pixels = {};
    drawn.reason = error.what();
  }
  return drawn;
}

}  // namespace mrroc::cli
