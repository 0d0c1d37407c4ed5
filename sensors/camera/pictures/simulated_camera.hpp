#pragma once

#include <optional>

#include "sensors/camera/pictures/faulty_camera.hpp"
#include "sensors/camera/pictures/picture_source.hpp"
#include "sensors/camera/simulated_view.hpp"
#include "sim/rendering/camera.hpp"
#include "vsp/noise.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// A camera of the simulated world. It draws the last stored state of the simulator (in lockstep the present tick's; in
/// real time the newest, of tick `raw.tick`) in this process, 4 samples per pixel, without shadows, and adds noise that
/// depends on (sensor, tick) only. With [sim.errors] the picture is that of the true camera, and of an
/// older state where it is late, while `intrinsics` and
/// `mount` stay the nominal ones. The same state gives the same picture, bit for bit, on one machine.
class SimulatedCamera final : public PictureSource {
 public:
  /// `picture` outlives it. Throws SystemError: no simulated world, no such camera, no OpenGL; ConfigurationError: a
  /// broken scene.
  SimulatedCamera(const SourceContext& context, cv::Mat& picture);

  SourceState read(Tick wanted, RawReading& raw) noexcept override;
  const Intrinsics& intrinsics() const noexcept override { return intrinsics_; }
  const Pose& mount() const noexcept override { return view_.camera.mount; }

 private:
  void draw();

  const core::SharedSlot<world::WorldSnapshot>* slot_;
  Tick silent_after_;
  Noise noise_;
  double noise_deviation_;
  sim::Model model_;
  SimulatedView view_;
  Intrinsics intrinsics_;
  std::optional<FaultyCamera> errors_;
  sim::Renderer renderer_;
  world::WorldSnapshot snapshot_{};
  sim::Picture drawn_;
  cv::Mat* picture_;
  cv::Mat noise_picture_;
  std::uint64_t pictures_ = 0;
  Tick drawn_tick_ = kNever;
};

}  // namespace mrroc::vsp
