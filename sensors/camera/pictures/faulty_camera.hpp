#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "config/entries/errors_entry.hpp"
#include "sensors/camera/simulated_view.hpp"

namespace mrroc::vsp {

/// A simulated camera with the errors of [sim.errors]: its pose differs from its mount, its focal length and its lens
/// differ from its intrinsics, lights cast shadows, its picture is blurred. One thread.
class FaultyCamera {
 public:
  FaultyCamera(const config::ErrorsEntry& errors, const std::string& sensor, const SimulatedView& nominal);

  /// The world as the true view without the lens shows it.
  void draw(sim::Renderer& renderer, sim::Picture& picture);
  /// Makes of a picture without distortion that of the lens, blurred.
  void distort(cv::Mat& picture);

 private:
  SimulatedView view_;
  double blur_;            ///< px
  double shadow_;          ///< part of the light
  sim::Picture shaded_;    ///< with all of it gone
  cv::Mat map_x_, map_y_;  ///< where each pixel of the true picture is in the ideal one; empty: no distortion
  cv::Mat changed_;
};

}  // namespace mrroc::vsp
