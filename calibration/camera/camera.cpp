#include <mrroc/ecp.hpp>

#include "calibration/camera/calibrate_camera.hpp"
#include "calibration/common/any_robot.hpp"
#include "calibration/common/camera_report.hpp"
#include "calibration/common/marker_views.hpp"

namespace mrroc::calibration {
namespace {

/// Finds where a camera stands by showing it a marker from many sides.
class CameraCalibration : public ecp::Task {
  AnyRobot arm{*this};
  MarkerViews views{*this, arm, Carried::marker};

  void calibrate(const CalibrateCamera& order) {
    require_fixed_base(*this, arm);
    ViewOrder shown = views.order_of(order);
    shown.cap.turn = 0.5;  // an arm has little room around what it holds
    shown.cap.joint_reach = 2;
    const AgreedFit agreed = views.estimate(shown);
    const std::string eye{order.sensor.view()};
    report_camera({.kind = "camera",
                   .eye = eye,
                   .device = "camera '" + eye + "', with robot '" + arm.name() + "'",
                   .pose = process().deployment().robot(arm.name()).known_base() * agreed.fit.camera,
                   .frame = "in the world",
                   .scale = process().deployment().sensor(eye).numbers.at("focal_scale").front(),
                   .residual_bound = order.residual_bound,
                   .into = std::string(order.into.view())},
                  agreed);
  }

 public:
  CameraCalibration() {
    on<CalibrateCamera>([this](const CalibrateCamera& order) { calibrate(order); });
  }
};

}  // namespace
}  // namespace mrroc::calibration

MRROC_ECP(mrroc::calibration::CameraCalibration)
