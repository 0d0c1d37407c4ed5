#include <mrroc/ecp.hpp>
#include <utility>
#include <vector>

#include "calibration/as_computed.hpp"
#include "calibration/common/any_robot.hpp"
#include "calibration/common/camera_report.hpp"
#include "calibration/common/marker_views.hpp"
#include "calibration/hand_eye/calibrate_hand_eye.hpp"
#include "kinematics/measured_chain.hpp"

namespace mrroc::calibration {
namespace {

/// Finds where a camera is on the flange by looking at a marker from many sides.
class HandEyeCalibration : public ecp::Task {
  AnyRobot arm{*this};
  MarkerViews views{*this, arm};

  /// Whether the errors of the arm are to be estimated, too: nothing is known of them, and its model is a chain of six.
  bool arm_is_unknown(const CalibrateHandEye& order) {
    if (process().deployment().robot(arm.name()).measured_arm) return false;
    const RobotModel& model = *arm.models().front();
    return order.joint_deviation == 0 && order.arm_deviation == 0 && model.joint_count() == 6 &&
           kinematics::is_chain(model);
  }

  void calibrate(const CalibrateHandEye& order) {
    ViewOrder look = views.order_of(order);
    const bool with_arm = arm_is_unknown(order);
    if (with_arm) look.priors = whole_arm_priors();
    const std::vector<MarkerView> seen = views.take(look);
    const RobotModel& model = *arm.models().front();
    AgreedFit agreed = agreed_fit(model, seen, look.priors);
    if (with_arm) agreed.fit = as_computed(model, seen, std::move(agreed.fit));  // tasks compute with the model
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
