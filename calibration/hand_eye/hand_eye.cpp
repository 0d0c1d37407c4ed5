#include <mrroc/ecp.hpp>

#include "calibration/common/any_robot.hpp"
#include "calibration/common/camera_report.hpp"
#include "calibration/common/marker_views.hpp"
#include "calibration/hand_eye/calibrate_hand_eye.hpp"

namespace mrroc::calibration {
namespace {

/// Finds where a camera is on the flange by looking at a marker from many sides.
class HandEyeCalibration : public ecp::Task {
  AnyRobot arm{*this};
  MarkerViews views{*this, arm};

  void calibrate(const CalibrateHandEye& order) {
    const AgreedFit agreed = views.estimate(view_order(order));
    const std::string eye{order.sensor.view()};
    report_camera({.kind = "hand-eye",
                   .eye = eye,
                   .device = "camera '" + eye + "' of robot '" + arm.name() + "'",
                   .pose = agreed.fit.camera,
                   .frame = "on the flange",
                   .scale = process().deployment().sensor(eye).numbers.at("focal_scale").front(),
                   .residual_bound = order.residual_bound,
                   .into = std::string(order.into.view())},
                  agreed);
  }

 public:
  HandEyeCalibration() {
    on<CalibrateHandEye>([this](const CalibrateHandEye& order) { calibrate(order); });
  }
};

}  // namespace
}  // namespace mrroc::calibration

MRROC_ECP(mrroc::calibration::HandEyeCalibration)
