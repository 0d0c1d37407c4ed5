#include "sensors/camera/pictures/simulated_camera.hpp"

#include <cmath>
#include <opencv2/core.hpp>

#include "sensors/camera/keys.hpp"
#include "sim/simulation.hpp"
#include "vsp/make_source.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::vsp {

namespace {

constexpr std::uint32_t kSeedStream = 0;

const world::WorldMemory& world_of(const SourceContext& context) {
  if (context.world == nullptr) {
    refuse(context.entry, "source", "'simulated' without a simulated world", "a table [sim]");
  }
  return *context.world;
}

void refuse_keys_of_hardware(const config::SensorEntry& entry) {
  const char* expected = "source = 'hardware' beside it";
  if (!text(entry, "device").empty()) refuse(entry, "device", "\"" + text(entry, "device") + "\"", expected);
  for (const auto& [key, size] : {std::pair{"intrinsics", 4}, {"distortion", 5}}) {
    if (optional_numbers(entry, key, static_cast<std::size_t>(size)))
      refuse(entry, key, "of a simulated camera", expected);
  }
}

double field_of_view(const config::SensorEntry& entry, const CameraMount& camera) {
  const double given = number(entry, "field_of_view");
  if (given > 0) return given;
  if (camera.field_of_view > 0) return camera.field_of_view;
  refuse(entry, "field_of_view", "0", "that of the picture's height, rad: the MJCF has no camera that gives it");
}

}  // namespace

SimulatedCamera::SimulatedCamera(const SourceContext& context, cv::Mat& picture)
    : slot_(&world_of(context).snapshot),
      silent_after_(static_cast<Tick>(std::ceil(kSilentAfter / context.servo_period))),
      noise_(context.entry.name),
      noise_deviation_(number(context.entry, "noise")),
      model_(sim::load_model(sim::compose(context.deployment))),
      camera_(find_camera(*model_, context.entry)),
      intrinsics_(Intrinsics::pinhole(whole(context.entry, "width"), whole(context.entry, "height"),
                                      field_of_view(context.entry, camera_))),
      field_of_view_(field_of_view(context.entry, camera_)),
      renderer_(*model_, intrinsics_.width, intrinsics_.height, {.samples = 4, .shadows = false}),
      picture_(&picture) {
  refuse_keys_of_hardware(context.entry);
}

SourceState SimulatedCamera::read(Tick wanted, RawReading& raw) noexcept {
  const bool there = slot_->load(snapshot_) || pictures_ > 0;  // during a write the previous state stays
  if (wanted > snapshot_.tick && wanted - snapshot_.tick > silent_after_) return SourceState::silent;
  if (!there) return SourceState::not_ready;
  if (snapshot_.tick != drawn_tick_) {
    try {
      if (!renderer_.place(snapshot_)) return SourceState::silent;
      draw();
    } catch (const std::exception&) {  // no memory, or OpenGL is lost
      return SourceState::silent;
    }
    drawn_tick_ = snapshot_.tick;
    ++pictures_;
  }
  raw.tick = drawn_tick_;
  raw.count = 1;
  raw.values[0] = static_cast<double>(pictures_);
  return SourceState::ready;
}

void SimulatedCamera::draw() {
  sim::Viewpoint view{renderer_.body_pose(camera_.body) * camera_.in_body, field_of_view_};
  view.pose.linear() *= Eigen::Vector3d(1, -1, -1).asDiagonal();
  renderer_.draw(view, drawn_);
  *picture_ = cv::Mat(drawn_.height, drawn_.width, CV_8UC3, drawn_.pixels.data());
  if (noise_deviation_ <= 0) return;
  cv::RNG random(static_cast<std::uint64_t>(noise_.uniform(snapshot_.tick, kSeedStream) * 0x1p53));
  noise_picture_.create(drawn_.height, drawn_.width, CV_16SC3);
  random.fill(noise_picture_, cv::RNG::NORMAL, 0, noise_deviation_);
  cv::add(*picture_, noise_picture_, *picture_, cv::noArray(), CV_8UC3);
}

}  // namespace mrroc::vsp
