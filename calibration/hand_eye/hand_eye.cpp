#include "calibration/hand_eye.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <mrroc/ecp.hpp>
#include <mrroc/sensors/camera.hpp>
#include <optional>

#include "calibration/common/any_robot.hpp"
#include "calibration/common/report.hpp"
#include "calibration/hand_eye/calibrate_hand_eye.hpp"
#include "calibration/view_postures.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::calibration {
namespace {

constexpr double kSettling = 0.6;        // s of rest before a picture
constexpr double kWorstRotation = 0.05;  // rad: a view with a larger deviation may be the mirrored pose
constexpr int kPictures = 4;             // of a posture
constexpr std::size_t kLeastViews = 6;

/// Finds where a camera is on the flange by looking at a marker from many sides.
class HandEyeCalibration : public ecp::Task {
  AnyRobot arm{*this};
  std::map<std::string, Camera> cameras;

  Camera& camera(const std::string& name) {
    const auto found = cameras.find(name);
    if (found == cameras.end())
      throw NonFatalError(ErrorCode::invalid_argument,
                          "CalibrateHandEye: '" + name + "' is no camera of robot '" + arm.name() + "'");
    return found->second;
  }

  /// The mean of several pictures at rest; nothing when the marker is not seen in all of them.
  std::optional<MarkerView> look(Camera& eye) {
    Move({arm}, {}, Hold{arm, kSettling});
    MarkerView view;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
    for (int picture = 0; picture < kPictures; ++picture) {
      Wait({arm}, {eye}, ElapsedSteps{1});
      if (!eye.detected() || !(eye.rotation_deviation() < kWorstRotation)) return std::nullopt;
      position += eye.position() / kPictures;
      rotation += eye.pose().linear() / kPictures;
      view.side = std::sqrt(eye.area());
    }
    view.joints = arm.state().joints;
    view.marker.translation() = position;
    view.marker.linear() = orthonormal(rotation);
    return view;
  }

  /// The views of those postures from which the marker is seen.
  std::vector<MarkerView> look_from(const std::vector<JointVector>& postures, Camera& eye, double speed) {
    std::vector<MarkerView> views;
    for (const JointVector& posture : postures) {
      Move({arm}, {}, JointLine{arm, posture, speed});
      if (const auto view = look(eye)) views.push_back(*view);
    }
    return views;
  }

  void calibrate(const CalibrateHandEye& order) {
    Camera& eye = camera(std::string(order.sensor.view()));
    if (order.marker >= 0) eye.configure(LookFor{order.marker, order.marker_size});
    Move({arm}, {}, Hold{arm, 0.1});
    const RobotModel& model = *arm.models().front();
    const JointVector start = arm.state().desired_joints;
    const std::optional<MarkerView> first = look(eye);
    if (!first)
      throw NonFatalError("camera '" + eye.name() +
                          "' does not see the marker clearly from the robot's present posture: move the robot there");
    std::vector<MarkerView> views = look_from(first_postures(model, start, order.reach), eye, order.speed);
    views.push_back(*first);
    const HandEyeFit rough = closed_form_hand_eye(model, views);
    views = look_from(view_postures(model, rough, start, static_cast<std::size_t>(order.views)), eye, order.speed);
    Move({arm}, {}, JointLine{arm, start, order.speed});
    if (views.size() < kLeastViews)
      throw NonFatalError("the marker was seen from " + std::to_string(views.size()) + " postures, expected at least " +
                          std::to_string(kLeastViews) + ": move the robot to a posture with more room around it");
    HandEyePriors priors;
    priors.joint = order.joint_deviation;
    priors.position = order.arm_deviation;
    priors.rotation = 2 * order.arm_deviation;
    report(order, eye.name(), fit_hand_eye(model, views, priors));
  }

  void report(const CalibrateHandEye& order, const std::string& eye, const HandEyeFit& fit) const {
    for (std::size_t k = 0; k < fit.residuals.size(); ++k)
      std::printf("view %2zu: residual %.3f mrad\n", k + 1, 1000 * fit.residuals[k]);
    const Eigen::Vector3d position = fit.camera.translation(), turns = rpy_of(fit.camera.linear());
    const double scale = process().deployment().sensor(eye).numbers.at("focal_scale").front() * (1 + fit.focal);
    std::printf("camera at (%.2f, %.2f, %.2f) mm +- %.2f on the flange\n", 1000 * position.x(), 1000 * position.y(),
                1000 * position.z(), 1000 * fit.position_deviation);
    std::printf("roll, pitch, yaw (%.5f, %.5f, %.5f) rad +- %.5f\n", turns.x(), turns.y(), turns.z(),
                fit.rotation_deviation);
    std::printf("focal length %.5f of the nominal one +- %.5f\n", scale, fit.focal_deviation);
    const std::vector<Bound> bounds{
        {"residual", "rad", *std::max_element(fit.residuals.begin(), fit.residuals.end()), order.residual_bound},
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
    for (const config::SensorEntry* entry : sensors_on(process().deployment(), arm.name(), "camera"))
      cameras.try_emplace(entry->name, *this, entry->name);
    on<CalibrateHandEye>([this](const CalibrateHandEye& order) { calibrate(order); });
  }
};

}  // namespace
}  // namespace mrroc::calibration

MRROC_ECP(mrroc::calibration::HandEyeCalibration)
