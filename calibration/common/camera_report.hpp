#pragma once

#include <filesystem>
#include <string>

#include "calibration/outlying_views.hpp"
#include "mrroc/types.hpp"

namespace mrroc::calibration {

/// The estimate of a camera, for its report.
struct FoundCamera {
  std::string kind;       ///< of the calibration
  std::string eye;        ///< the sensor
  std::string device;     ///< what was calibrated, for the file
  Pose pose;              ///< of the camera in `frame`
  std::string frame;      ///< "in the world"
  double scale = 1;       ///< of the focal length, as deployed
  double residual_bound;  ///< rad
  std::filesystem::path into;
};

/// Prints the estimate and the verdict, and writes the calibration file. Throws as `judge`, `write_calibration`. Task's
/// thread.
void report_camera(const FoundCamera& found, const AgreedFit& agreed);

}  // namespace mrroc::calibration
