#include "calibration/common/marker_views.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "calibration/short_tour.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::calibration {

namespace {

constexpr double kSettling = 0.6;        // s of rest before a picture
constexpr double kWorstRotation = 0.05;  // rad: a view with a larger deviation may be the mirrored pose
constexpr int kPictures = 4;             // of a posture
constexpr std::size_t kLeastViews = 6;
constexpr std::size_t kPosturesPerLine = 10;

/// How well an arm is known: zeros of its joints, rad or m, and its flange from posture to posture, m.
struct ArmDeviation {
  double joint, flange;
};
constexpr ArmDeviation kArmOfItsType{3e-4, 1e-4}, kMeasuredArm{3e-5, 1e-5};

/// The mean of several pictures at rest; nothing when the marker is not seen in all of them.
std::optional<MarkerView> take_view(Robot& arm, Camera& eye) {
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

}  // namespace

double MarkerViews::deployed_size(const Camera& eye) const {
  return task_.process().deployment().sensor(eye.name()).numbers.at("marker_size").front();
}

MarkerViews::MarkerViews(ecp::Task& task, Robot& arm, Carried carried) : task_(task), arm_(arm), carried_(carried) {
  const std::string carrier = carried == Carried::camera ? arm.name() : "";
  for (const config::SensorEntry* entry : sensors_on(task.process().deployment(), carrier, "camera"))
    cameras_.try_emplace(entry->name, task, entry->name);
}

/// A deviation of 0 is that of this arm.
HandEyePriors MarkerViews::priors_of(double joint, double arm) const {
  const auto& measured = task_.process().deployment().robot(arm_.name()).measured_arm;
  const ArmDeviation known = measured ? kMeasuredArm : kArmOfItsType;
  HandEyePriors priors = arm_priors(joint > 0 ? joint : known.joint, arm > 0 ? arm : known.flange);
  if (joint > 0) priors.play = std::min(priors.play, joint);
  return priors;
}

/// The views of those postures from which the marker is seen. The joints come to every second one from below, to the
/// others from above, at the two sides of their play. Prints how far it is, as this takes minutes.
std::vector<MarkerView> MarkerViews::seen_from(const std::vector<JointVector>& postures, Camera& eye, double speed) {
  std::vector<MarkerView> views;
  int approach = 1;
  for (std::size_t k = 0; k < postures.size(); ++k) {
    Move({arm_}, {}, JointLine{arm_, beside_posture(postures[k], approach), speed});
    Move({arm_}, {}, JointLine{arm_, postures[k], speed});
    if (const auto view = take_view(arm_, eye)) views.emplace_back(*view).approach = approach;
    approach = -approach;
    if ((k + 1) % kPosturesPerLine == 0 || k + 1 == postures.size()) {
      std::printf("posture %2zu of %zu, the marker seen from %zu\n", k + 1, postures.size(), views.size());
      std::fflush(stdout);
    }
  }
  return views;
}

std::vector<MarkerView> MarkerViews::take(const ViewOrder& order) {
  const auto found = cameras_.find(order.sensor);
  if (found == cameras_.end())
    throw NonFatalError(ErrorCode::invalid_argument,
                        "'" + order.sensor + "' is not a camera " +
                            (carried_ == Carried::camera ? "of robot '" + arm_.name() + "'" : "that does not move"));
  Camera& eye = found->second;
  if (order.marker >= 0)
    eye.configure(LookFor{order.marker, order.marker_size > 0 ? order.marker_size : deployed_size(eye)});
  Move({arm_}, {}, Hold{arm_, 0.1});
  const RobotModel& model = *arm_.models().front();
  const JointVector start = arm_.state().desired_joints;
  const std::optional<MarkerView> first = take_view(arm_, eye);
  if (!first)
    throw NonFatalError("camera '" + eye.name() +
                        "' does not see the marker clearly from the robot's present posture: move the robot there");
  std::vector<MarkerView> views = seen_from(first_postures(model, start, order.reach), eye, order.speed);
  views.push_back(*first);
  const HandEyeFit rough = closed_form_hand_eye(model, views, carried_);
  const auto count = static_cast<std::size_t>(order.views);
  const auto postures = short_tour(model, start, view_postures(model, rough, start, count, order.cap));
  views = seen_from(postures, eye, order.speed);
  Move({arm_}, {}, JointLine{arm_, start, order.speed});
  if (views.size() < kLeastViews)
    throw NonFatalError("the marker was seen from " + std::to_string(views.size()) + " postures, expected at least " +
                        std::to_string(kLeastViews) + ": move the robot to a posture with more room around it");
  return views;
}

AgreedFit MarkerViews::estimate(const ViewOrder& order) {
  return agreed_fit(*arm_.models().front(), take(order), order.priors, carried_);
}

AgreedFit agreed_fit(const RobotModel& model, const std::vector<MarkerView>& views, const HandEyePriors& priors,
                     Carried carried) {
  AgreedFit agreed = fit_of_agreeing_views(model, views, priors, carried);
  if (agreed.used.size() < kLeastViews)
    throw NonFatalError(std::to_string(agreed.used.size()) +
                        " views of the marker agree with each other, expected at least " + std::to_string(kLeastViews) +
                        ": move the robot to a posture with more room around it");
  return agreed;
}

double print_residuals(const AgreedFit& agreed) {
  std::vector<double> residuals = agreed.fit.residuals;
  std::sort(residuals.begin(), residuals.end());
  std::printf("%zu views: residual %.3f to %.3f mrad, median %.3f mrad\n", residuals.size(), 1000 * residuals.front(),
              1000 * residuals.back(), 1000 * residuals[residuals.size() / 2]);
  for (const std::size_t view : agreed.left_out)
    std::printf("view %2zu: left out, it contradicts the others\n", view + 1);
  return residuals.back();
}

}  // namespace mrroc::calibration
