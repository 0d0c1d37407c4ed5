#include "sensors/camera/pictures/simulated_camera.hpp"

#include <cmath>
#include <opencv2/core.hpp>

#include "sim/errors/true_errors.hpp"
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

}  // namespace

SimulatedCamera::SimulatedCamera(const SourceContext& context, cv::Mat& picture)
    : slot_(&world_of(context).snapshot),
      silent_after_(static_cast<Tick>(std::ceil(kSilentAfter / context.servo_period))),
      noise_(context.entry.name),
      noise_deviation_(number(context.entry, "noise")),
      model_(sim::load_model(sim::compose(context.deployment))),
      view_(view_of(*model_, context.entry)),
      intrinsics_(Intrinsics::pinhole(view_.width, view_.height, view_.field_of_view)),
      renderer_(*model_, view_.width, view_.height, SimulatedView::kQuality),
      picture_(&picture) {
  const auto& sim = context.deployment.sim;
  if (!sim || !sim->errors) return;
  errors_.emplace(*sim->errors, context.entry.name, view_);
  if (sim::latency_of_cameras(*sim->errors, context.servo_period) > 0) slot_ = &context.world->seen;
  noise_deviation_ = std::hypot(noise_deviation_, sim->errors->pixel_noise);
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
  if (errors_)
    errors_->draw(renderer_, drawn_);
  else
    view_.draw(renderer_, drawn_);
  *picture_ = cv::Mat(drawn_.height, drawn_.width, CV_8UC3, drawn_.pixels.data());
  if (errors_) errors_->distort(*picture_);
  if (noise_deviation_ <= 0) return;
  cv::RNG random(static_cast<std::uint64_t>(noise_.uniform(snapshot_.tick, kSeedStream) * 0x1p53));
  noise_picture_.create(drawn_.height, drawn_.width, CV_16SC3);
  random.fill(noise_picture_, cv::RNG::NORMAL, 0, noise_deviation_);
  cv::add(*picture_, noise_picture_, *picture_, cv::noArray(), CV_8UC3);
}

}  // namespace mrroc::vsp
