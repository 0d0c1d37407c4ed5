#include "cli/pictures/hardware_view.hpp"

#include "sensors/camera/keys.hpp"

namespace mrroc::cli {

namespace {

vsp::Intrinsics intrinsics_of(const config::SensorEntry& camera) {
  vsp::Intrinsics given = vsp::given_intrinsics(camera).value_or(
      vsp::Intrinsics{camera.picture_width(), camera.picture_height(), 0, 0, 0, 0, {}});
  if (const auto scale = camera.numbers.find("focal_scale"); scale != camera.numbers.end() && !scale->second.empty()) {
    given.fx *= scale->second.front();
    given.fy *= scale->second.front();
  }
  return given;
}

}  // namespace

HardwareView::HardwareView(const config::SensorEntry& camera, const std::filesystem::path& file)
    : intrinsics_(intrinsics_of(camera)),
      memory_(process::PictureMemory::open(file, camera.picture_width(), camera.picture_height())) {}

std::optional<Tick> HardwareView::load(sim::Picture& picture) {
  const std::uint64_t before = memory_.sequence();
  Tick tick = 0;
  if (!memory_.load(tick, picture.pixels)) return std::nullopt;
  picture.width = intrinsics_.width;
  picture.height = intrinsics_.height;
  loaded_ = before;  // one that was stored meanwhile is loaded again
  return tick;
}

}  // namespace mrroc::cli
