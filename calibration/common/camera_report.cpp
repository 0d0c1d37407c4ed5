#include "calibration/common/camera_report.hpp"

#include <cstdio>

#include "calibration/common/marker_views.hpp"
#include "calibration/common/report.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::calibration {

void report_camera(const FoundCamera& found, const AgreedFit& agreed) {
  const HandEyeFit& fit = agreed.fit;
  const double residual = print_residuals(agreed);
  const Eigen::Vector3d position = found.pose.translation(), rotation = rpy_of(found.pose.linear());
  const double scale = found.scale * (1 + fit.focal);
  std::printf("camera at (%.2f, %.2f, %.2f) mm +- %.2f %s\n", 1000 * position.x(), 1000 * position.y(),
              1000 * position.z(), 1000 * fit.position_deviation, found.frame.c_str());
  std::printf("roll, pitch, yaw (%.5f, %.5f, %.5f) rad +- %.5f\n", rotation.x(), rotation.y(), rotation.z(),
              fit.rotation_deviation);
  std::printf("focal length %.5f of the nominal one +- %.5f\n", scale, fit.focal_deviation);
  const std::vector<Bound> bounds{{"residual", "rad", residual, found.residual_bound},
                                  {"deviation of the position", "m", fit.position_deviation, 0.002},
                                  {"deviation of the rotation", "rad", fit.rotation_deviation, 0.004}};
  judge(bounds);
  write_calibration(found.into, found.kind, found.device, bounds,
                    "[sensors." + found.eye + "]\nmount_position = " + toml_list(position) + "  # m, " + found.frame +
                        "\nmount_rotation = " + toml_list(rotation) + "  # rad\nfocal_scale = " + shown_number(scale) +
                        "\n");
}

}  // namespace mrroc::calibration
