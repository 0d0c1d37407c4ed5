#include "sensors/camera/pictures/faulty_camera.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sensors/camera/intrinsics.hpp"
#include "sim/errors/true_errors.hpp"

namespace mrroc::vsp {

FaultyCamera::FaultyCamera(const config::ErrorsEntry& errors, const std::string& sensor, const SimulatedView& nominal)
    : view_(nominal), blur_(errors.blur), shadow_(errors.shadow) {
  const sim::TrueLens lens = sim::error_of_lens(errors, sensor);
  view_.camera.in_body = nominal.camera.in_body * sim::error_of_camera(errors, sensor);
  view_.field_of_view = 2 * std::atan(std::tan(nominal.field_of_view / 2) / (1 + lens.focal));
  if (lens.k1 == 0) return;
  Intrinsics intrinsics = Intrinsics::pinhole(view_.width, view_.height, view_.field_of_view);
  intrinsics.distortion[0] = lens.k1;
  std::vector<Eigen::Vector2d> pixels;
  for (int v = 0; v < view_.height; ++v)
    for (int u = 0; u < view_.width; ++u) pixels.emplace_back(u, v);
  pixels = intrinsics.ideal(std::move(pixels));
  map_x_.create(view_.height, view_.width, CV_32FC1);
  map_y_.create(view_.height, view_.width, CV_32FC1);
  auto ideal = pixels.cbegin();
  for (int v = 0; v < view_.height; ++v) {
    for (int u = 0; u < view_.width; ++u, ++ideal) {
      map_x_.at<float>(v, u) = static_cast<float>(ideal->x());
      map_y_.at<float>(v, u) = static_cast<float>(ideal->y());
    }
  }
}

void FaultyCamera::draw(sim::Renderer& renderer, sim::Picture& picture) {
  view_.draw(renderer, picture);
  if (shadow_ <= 0) return;
  renderer.use_shadows(true);
  view_.draw(renderer, shaded_);
  renderer.use_shadows(false);
  const auto pixels = [](sim::Picture& of) { return cv::Mat(of.height, of.width, CV_8UC3, of.pixels.data()); };
  cv::Mat result = pixels(picture);
  cv::addWeighted(result, 1 - shadow_, pixels(shaded_), shadow_, 0, result);
}

void FaultyCamera::distort(cv::Mat& picture) {
  if (!map_x_.empty()) {
    cv::remap(picture, changed_, map_x_, map_y_, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    changed_.copyTo(picture);
  }
  if (blur_ <= 0) return;
  cv::GaussianBlur(picture, changed_, {}, blur_);
  changed_.copyTo(picture);
}

}  // namespace mrroc::vsp
