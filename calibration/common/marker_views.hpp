#pragma once

#include <map>
#include <string>
#include <vector>

#include "calibration/common/any_robot.hpp"
#include "calibration/outlying_views.hpp"
#include "calibration/view_postures.hpp"
#include "mrroc/sensors/camera.hpp"

namespace mrroc::calibration {

/// How a camera sees a marker while a robot carries one of the two.
struct ViewOrder {
  std::string sensor;      ///< the camera
  int marker = -1;         ///< of its dictionary; -1: as deployed
  double marker_size = 0;  ///< m, beside `marker`; 0: as deployed
  int views = 40;          ///< postures, at most
  double reach = 0.12;     ///< rad or m of the last three joints, for the first estimate
  double speed = 0.5;      ///< as JointLine's
  HandEyePriors priors;
  ViewCap cap = {};
};

/// The cameras on the flange of a robot, or those that do not move while the robot carries a marker; their readings are
/// in the camera frame. Task's thread.
class MarkerViews {
 public:
  /// While the task is being built. Throws as `Camera`.
  MarkerViews(ecp::Task& task, Robot& arm, Carried carried = Carried::camera);

  /// That of a behaviour with these fields; one without `reach` has the default.
  template <class Order>
  ViewOrder order_of(const Order& order) const {
    ViewOrder views{.sensor = std::string(order.sensor.view()),
                    .marker = order.marker,
                    .marker_size = order.marker_size,
                    .views = order.views,
                    .speed = order.speed,
                    .priors = priors_of(order.joint_deviation, order.arm_deviation)};
    if constexpr (requires { order.reach; }) views.reach = order.reach;
    return views;
  }

  /// Looks at the marker in postures around the present one, in which it is seen, and returns. Nothing may block the
  /// view of the marker. Throws NonFatalError: no such camera, or too few views.
  std::vector<MarkerView> take(const ViewOrder& order);

  /// Takes views and estimates the poses of camera and marker from them (`agreed_fit`). Throws as both.
  AgreedFit estimate(const ViewOrder& order);

 private:
  HandEyePriors priors_of(double joint, double arm) const;

  std::vector<MarkerView> seen_from(const std::vector<JointVector>& postures, Camera& eye, double speed);

  double deployed_size(const Camera& eye) const;

  ecp::Task& task_;
  Robot& arm_;
  Carried carried_;
  std::map<std::string, Camera> cameras_;
};

/// `fit_of_agreeing_views`. Throws also NonFatalError when too few views agree. Any thread.
AgreedFit agreed_fit(const RobotModel& model, const std::vector<MarkerView>& views, const HandEyePriors& priors,
                     Carried carried = Carried::camera);

/// Prints the least, the median and the largest residual of the views, and which were left out; returns the largest,
/// rad. Task's thread.
double print_residuals(const AgreedFit& agreed);

}  // namespace mrroc::calibration
