#include <cmath>
#include <cstdio>
#include <mrroc/ecp.hpp>

#include "calibration/base/calibrate_base.hpp"
#include "calibration/common/any_robot.hpp"
#include "calibration/common/marker_views.hpp"
#include "calibration/common/report.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::calibration {
namespace {

/// Finds where the robot stands by looking at a marker whose place is known.
class BaseCalibration : public ecp::Task {
  AnyRobot arm{*this};
  MarkerViews views{*this, arm};

  void calibrate(const CalibrateBase& order) {
    require_fixed_base(*this, arm);
    const AgreedFit agreed = views.estimate(views.order_of(order));
    const HandEyeFit& fit = agreed.fit;
    const double residual = print_residuals(agreed);
    const Pose marker = pose_from_rpy({order.x, order.y, order.z}, {order.roll, order.pitch, order.yaw});
    const Pose base = marker * fit.marker.inverse();
    const Eigen::Vector3d position = base.translation(), turns = rpy_of(base.linear());
    // what is wrong is the marker in the base frame: its rotation moves the base on an arm of that length
    const double deviation =
        std::hypot(fit.marker_position_deviation, fit.marker_rotation_deviation * fit.marker.translation().norm());
    std::printf("base at (%.2f, %.2f, %.2f) mm +- %.2f in the world\n", 1000 * position.x(), 1000 * position.y(),
                1000 * position.z(), 1000 * deviation);
    std::printf("roll, pitch, yaw (%.5f, %.5f, %.5f) rad +- %.5f\n", turns.x(), turns.y(), turns.z(),
                fit.marker_rotation_deviation);
    const Pose before = process().deployment().robot(arm.name()).known_base();
    const double distance = (position - before.translation()).norm();
    const double angle = rotation_vector(before.linear().transpose() * base.linear()).norm();
    std::printf("%.2f mm and %.5f rad from where the deployment has it\n", 1000 * distance, angle);
    const std::vector<Bound> bounds{{"residual", "rad", residual, order.residual_bound},
                                    {"deviation of the position", "m", deviation, 0.003},
                                    {"deviation of the rotation", "rad", fit.marker_rotation_deviation, 0.004},
                                    {"distance from the deployment's base", "m", distance, order.distance_bound}};
    judge(bounds);
    write_calibration(std::string(order.into.view()), "base", "robot '" + arm.name() + "'", bounds,
                      "[robots." + arm.name() + "]\nbase_position = " + toml_list(position) +
                          "  # m, in the world\nbase_rotation = " + toml_list(turns) + "  # rad\n");
  }

 public:
  BaseCalibration() {
    on<CalibrateBase>([this](const CalibrateBase& order) { calibrate(order); });
  }
};

}  // namespace
}  // namespace mrroc::calibration

MRROC_ECP(mrroc::calibration::BaseCalibration)
