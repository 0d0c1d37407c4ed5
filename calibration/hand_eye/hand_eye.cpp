#include <cstdio>
#include <mrroc/ecp.hpp>

#include "calibration/common/any_robot.hpp"
#include "calibration/common/marker_views.hpp"
#include "calibration/common/report.hpp"
#include "calibration/hand_eye/calibrate_hand_eye.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::calibration {
namespace {

/// Finds where a camera is on the flange by looking at a marker from many sides.
class HandEyeCalibration : public ecp::Task {
  AnyRobot arm{*this};
  MarkerViews views{*this, arm};

  void calibrate(const CalibrateHandEye& order) {
    const std::string eye{order.sensor.view()};
    const AgreedFit agreed = views.estimate({.sensor = eye,
                                             .marker = order.marker,
                                             .marker_size = order.marker_size,
                                             .views = order.views,
                                             .reach = order.reach,
                                             .speed = order.speed,
                                             .priors = arm_priors(order.joint_deviation, order.arm_deviation)});
    const HandEyeFit& fit = agreed.fit;
    const double residual = print_residuals(agreed);
    const Eigen::Vector3d position = fit.camera.translation(), turns = rpy_of(fit.camera.linear());
    const double scale = process().deployment().sensor(eye).numbers.at("focal_scale").front() * (1 + fit.focal);
    std::printf("camera at (%.2f, %.2f, %.2f) mm +- %.2f on the flange\n", 1000 * position.x(), 1000 * position.y(),
                1000 * position.z(), 1000 * fit.position_deviation);
    std::printf("roll, pitch, yaw (%.5f, %.5f, %.5f) rad +- %.5f\n", turns.x(), turns.y(), turns.z(),
                fit.rotation_deviation);
    std::printf("focal length %.5f of the nominal one +- %.5f\n", scale, fit.focal_deviation);
    const std::vector<Bound> bounds{{"residual", "rad", residual, order.residual_bound},
                                    {"deviation of the position", "m", fit.position_deviation, 0.002},
                                    {"deviation of the rotation", "rad", fit.rotation_deviation, 0.004}};
    judge(bounds);
    write_calibration(std::string(order.into.view()), "hand-eye", "camera '" + eye + "' of robot '" + arm.name() + "'",
                      bounds,
                      "[sensors." + eye + "]\nmount_position = " + toml_list(position) +
                          "  # m, in the flange frame\nmount_rotation = " + toml_list(turns) +
                          "  # rad\nfocal_scale = " + shown_number(scale) + "\n");
  }

 public:
  HandEyeCalibration() {
    on<CalibrateHandEye>([this](const CalibrateHandEye& order) { calibrate(order); });
  }
};

}  // namespace
}  // namespace mrroc::calibration

MRROC_ECP(mrroc::calibration::HandEyeCalibration)
