#include "sensors/camera/debug_view.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <locale>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include "command/write_file.hpp"
#include "config/table.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::vsp {

namespace {

cv::Scalar white() { return {255, 255, 255}; }
cv::Scalar black() { return {0, 0, 0}; }
cv::Scalar yellow() { return {255, 230, 0}; }

/// Pixels with fractions, as OpenCV's drawing takes them.
constexpr int kFraction = 4;

cv::Point fine(const Eigen::Vector2d& pixel) {
  return {static_cast<int>(std::lround(pixel.x() * (1 << kFraction))),
          static_cast<int>(std::lround(pixel.y() * (1 << kFraction)))};
}

void draw_line(cv::Mat& picture, const Eigen::Vector2d& a, const Eigen::Vector2d& b, const cv::Scalar& colour) {
  cv::line(picture, fine(a), fine(b), colour, 2, cv::LINE_AA, kFraction);
}

void draw_found(cv::Mat& picture, const Detection& found, const Intrinsics& intrinsics) {
  for (std::size_t i = 0; i < found.outline.size(); ++i) {
    const Eigen::Vector2d& next = found.outline[(i + 1) % found.outline.size()];
    cv::line(picture, fine(found.outline[i]), fine(next), yellow(), 1, cv::LINE_AA, kFraction);
  }
  const double length = 0.6 * std::sqrt(found.area);
  const std::array<cv::Scalar, 3> colours{cv::Scalar(255, 0, 0), {0, 200, 0}, {0, 60, 255}};
  for (int i = 2; i >= 0; --i) {
    const Eigen::Vector3d tip = found.pose * Eigen::Vector3d(length * Eigen::Vector3d::Unit(i));
    if (tip.z() > 0) draw_line(picture, found.pixel, intrinsics.project(tip), colours[static_cast<std::size_t>(i)]);
  }
  cv::circle(picture, fine(found.pixel), 3 << kFraction, white(), 1, cv::LINE_AA, kFraction);
}

void draw_text(cv::Mat& picture, int line, const char* text) {
  const cv::Point at(6, 16 + 15 * line);
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.42, black(), 3, cv::LINE_AA);
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.42, white(), 1, cv::LINE_AA);
}

void draw_figures(cv::Mat& picture, const SensorReading& v) {
  std::array<char, 96> text{};
  const auto& x = v.values;
  std::snprintf(text.data(), text.size(), "x %.4f  y %.4f  z %.4f m", x[1], x[2], x[3]);
  draw_text(picture, 1, text.data());
  std::snprintf(text.data(), text.size(), "q %.4f  %.4f  %.4f  %.4f", x[4], x[5], x[6], x[7]);
  draw_text(picture, 2, text.data());
  std::snprintf(text.data(), text.size(), "deviation %.2f  %.2f  %.2f mm, %.2f deg", 1e3 * x[8], 1e3 * x[9],
                1e3 * x[10], x[11] * 180 / CV_PI);
  draw_text(picture, 3, text.data());
  std::snprintf(text.data(), text.size(), "u %.1f  v %.1f  error %.2f px  area %.1f cm2", x[12], x[13], x[14],
                1e4 * x[15]);
  draw_text(picture, 4, text.data());
}

}  // namespace

DebugView::DebugView(const std::filesystem::path& folder, std::string sensor, int every, const Intrinsics& intrinsics)
    : folder_(folder), sensor_(std::move(sensor)), every_(every), intrinsics_(intrinsics) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(17) << "width = " << intrinsics.width << "\nheight = " << intrinsics.height
       << "\nintrinsics = [" << intrinsics.fx << ", " << intrinsics.fy << ", " << intrinsics.cx << ", " << intrinsics.cy
       << "]\n";
  const std::filesystem::path file = folder_ / (sensor_ + ".toml");
  try {
    description_.emplace(file, "the description of the pictures");
    const std::string bytes = text.str();
    command::write_file(file, std::as_bytes(std::span(bytes)));
  } catch (const process::FileInUse& in_use) {
    throw config::ConfigurationError(folder_, 0, sensor_, in_use.what(), "");
  } catch (const std::runtime_error& failure) {
    throw SystemError(ErrorCode::resources,
                      "cannot write into the folder of pictures " + folder_.string() + ": " + failure.what(),
                      {"", sensor_, 0, 0});
  }
}

void DebugView::show(const cv::Mat& picture, const Detection* found, const SensorReading& v) {
  if (readings_++ % static_cast<std::uint64_t>(every_) != 0) return;
  cv::Mat drawn = picture.clone();
  if (found != nullptr) draw_found(drawn, *found, intrinsics_);
  std::array<char, 96> title{};
  std::snprintf(title.data(), title.size(), "%.31s, tick %llu%s", sensor_.c_str(),
                static_cast<unsigned long long>(v.tick), found == nullptr ? ": nothing found" : "");
  draw_text(drawn, 0, title.data());
  if (found != nullptr && v.error.error_class == ErrorClass::none) draw_figures(drawn, v);
  write(drawn, v.tick);
}

void DebugView::write(const cv::Mat& picture, Tick tick) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "%.31s_%08llu.png", sensor_.c_str(), static_cast<unsigned long long>(tick));
  cv::Mat bgr;
  cv::cvtColor(picture, bgr, cv::COLOR_RGB2BGR);
  std::vector<unsigned char> png;
  const std::filesystem::path file = folder_ / name.data();
  std::string reason = "it cannot be encoded";
  try {
    if (cv::imencode(".png", bgr, png)) {
      command::write_file(file, std::as_bytes(std::span(png)));
      return;
    }
  } catch (const SystemError& error) {
    reason = error.detail();
    std::error_code ignored;
    std::filesystem::remove(file, ignored);  // half a picture
  }
  if (!std::exchange(reported_, true))
    std::fprintf(stderr, "%s: cannot write the picture %s: %s\n", sensor_.c_str(), file.c_str(), reason.c_str());
}

}  // namespace mrroc::vsp
