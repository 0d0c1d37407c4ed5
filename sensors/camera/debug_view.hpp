#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "mrroc/sensor_link.hpp"
#include "process/record/claimed_file.hpp"
#include "sensors/camera/detection/detection.hpp"

namespace mrroc::vsp {

/// Annotated pictures of the detections: `<folder>/<sensor>_<tick>.png` (the tick with eight digits) of every n-th
/// reading, with the outline, the axes of the pose (x red, y green, z blue) and the reading's values; and
/// `<sensor>.toml` with the camera's intrinsics. This object claims that file for its lifetime: no other run writes
/// pictures of a sensor of this name into the folder. A picture that cannot be written is reported once on stderr and
/// does not affect the reading.
class DebugView {
 public:
  /// Makes the folder. Throws ConfigurationError when another process writes the pictures of such a sensor there,
  /// SystemError(resources) when it cannot be written.
  DebugView(const std::filesystem::path& folder, std::string sensor, int every, const Intrinsics& intrinsics);

  /// `found`: null without a detection. `v`: the resulting reading, in `frame`.
  void show(const cv::Mat& picture, const Detection* found, const SensorReading& v);

 private:
  void write(const cv::Mat& picture, Tick tick);

  std::filesystem::path folder_;
  std::string sensor_;
  int every_;
  Intrinsics intrinsics_;
  std::optional<process::ClaimedFile> description_;
  std::uint64_t readings_ = 0;
  bool reported_ = false;
};

}  // namespace mrroc::vsp
