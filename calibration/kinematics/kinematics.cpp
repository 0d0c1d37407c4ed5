#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mrroc/ecp.hpp>

#include "calibration/common/any_robot.hpp"
#include "calibration/common/load_models.hpp"
#include "calibration/common/marker_views.hpp"
#include "calibration/common/report.hpp"
#include "calibration/kinematics/calibrate_kinematics.hpp"
#include "kinematics/measured_chain.hpp"
#include "kinematics/measured_joints.hpp"

namespace mrroc::calibration {
namespace {

constexpr std::size_t kKeptOut = 5;  // every fifth view
constexpr double kExact = 1e-9;      // rad or m: of joints that are not estimated
// the ranges of the keys
constexpr double kLargestZero = 0.2, kLargestGear = 0.05, kLargestPosition = 0.05, kLargestRotation = 0.1;  // rad, m

/// Root mean square of the residuals of views that an estimate has not seen, rad.
double expected_residual(const RobotModel& model, const HandEyeFit& fit, const std::vector<MarkerView>& views) {
  double squares = 0;
  for (const MarkerView& view : views) squares += std::pow(residual_of(model, fit, view), 2);
  return std::sqrt(squares / static_cast<double>(views.size()));
}

/// To nanometres: what no view shows is 0, not a rounding error.
template <class Values>
Values rounded(const Values& values) {
  return values.unaryExpr([](double value) { return std::round(value * 1e9) / 1e9 + 0.0; });
}

using Triples = std::vector<Eigen::Vector3d>;

/// Of each link the three numbers from number `from` of its six on.
Triples part(const std::vector<Twist>& links, Eigen::Index from) {
  Triples part;
  for (const Twist& link : links) part.emplace_back(link.segment<3>(from));
  return part;
}

double largest(const Triples& triples) {
  double largest = 0;
  for (const Eigen::Vector3d& triple : triples) largest = std::max(largest, triple.cwiseAbs().maxCoeff());
  return largest;
}

std::string toml_line(const char* key, const Triples& triples, const char* unit) {
  if (triples.empty()) return "";
  Eigen::VectorXd numbers(3 * std::ssize(triples));
  for (std::size_t i = 0; i < triples.size(); ++i) numbers.segment<3>(3 * static_cast<Eigen::Index>(i)) = triples[i];
  return std::string(key).append(" = ").append(toml_list(rounded(numbers))).append("  # ").append(unit).append("\n");
}

/// Finds zeros, gears and axes of an arm by looking at a marker from many sides.
class KinematicCalibration : public ecp::Task {
  AnyRobot arm{*this};
  MarkerViews marker{*this, arm};

  void calibrate(const CalibrateKinematics& order) {
    const config::RobotEntry& entry = process().deployment().robot(arm.name());
    const RobotModels models = load_models(entry.type, entry.files().parameters);  // not as measured before
    const RobotModel& model = *models.front();
    const bool with_links = model.joint_count() == 6 && order.link_deviation > 0;
    if (with_links) kinematics::measured_chain(model);  // refused before anything moves
    ViewOrder view_order = marker.order_of(order);
    view_order.priors.corner = whole_arm_priors().corner;
    view_order.cap.farthest = 2;
    std::vector<MarkerView> views = marker.take(view_order);
    const kinematics::MeasuredJoints deployed(entry.measured_arm, model.joint_count());
    for (MarkerView& view : views) view.joints = deployed.encoders(view.joints);

    HandEyePriors nominal = view_order.priors, measured = view_order.priors;
    nominal.joint = kExact;
    if (with_links) measured.link_position = measured.link_rotation = order.link_deviation;
    measured.gear = order.gear_deviation;
    const AgreedFit agreed = agreed_fit(model, views, measured);
    std::vector<MarkerView> used, kept_out;
    for (std::size_t k = 0; k < agreed.used.size(); ++k)
      (k % kKeptOut == 0 ? kept_out : used).push_back(views[agreed.used[k]]);
    const double before = expected_residual(model, fit_hand_eye(model, used, nominal), kept_out);
    const double after = expected_residual(model, fit_hand_eye(model, used, measured), kept_out);

    const double residual = print_residuals(agreed);
    print(agreed.fit);
    std::printf("views that were kept out are expected within %.3f mrad, %.3f mrad before\n", 1000 * after,
                1000 * before);
    const std::vector<Bound> bounds{
        {"residual", "rad", residual, order.residual_bound},
        {"residual of views kept out", "rad", after, 1.1 * before},
        {"largest zero", "rad", agreed.fit.arm.zeros.cwiseAbs().maxCoeff(), kLargestZero},
        {"largest gear", "rad", largest(agreed.fit.arm.gears), kLargestGear},
        {"largest link", "m", largest(part(agreed.fit.arm.links, 0)), kLargestPosition},
        {"largest turn of a link", "rad", largest(part(agreed.fit.arm.links, 3)), kLargestRotation}};
    judge(bounds);
    write_calibration(std::string(order.into.view()), "kinematics", "robot '" + arm.name() + "'", bounds,
                      text_of(agreed.fit));
  }

  static void print(const HandEyeFit& fit) {
    for (Eigen::Index i = 0; i < fit.arm.zeros.size(); ++i) {
      std::printf("axis %td: zero %.5f rad", i + 1, rounded(fit.arm.zeros)[i]);
      if (!fit.arm.gears.empty()) {
        const Eigen::Vector3d gear = 1000 * rounded(fit.arm.gears[static_cast<std::size_t>(i)]);
        std::printf(", gear (%.3f, %.3f, %.3f) mrad", gear[0], gear[1], gear[2]);
      }
      if (!fit.arm.links.empty()) {
        const Twist link = 1000 * rounded(fit.arm.links[static_cast<std::size_t>(i)]);
        std::printf(", link (%.3f, %.3f, %.3f) mm, (%.3f, %.3f, %.3f) mrad", link[0], link[1], link[2], link[3],
                    link[4], link[5]);
      }
      std::printf("\n");
    }
    std::printf("zeros +- %.5f rad at most\n", fit.joint_deviation);
  }

  std::string text_of(const HandEyeFit& fit) const {
    std::string text =
        "[robots." + arm.name() + "]\njoint_zeros = " + toml_list(rounded(fit.arm.zeros)) + "  # rad or m\n";
    text += toml_line("joint_gears", fit.arm.gears, "rad, of each axis");
    text += toml_line("link_positions", part(fit.arm.links, 0), "m, of each axis");
    text += toml_line("link_rotations", part(fit.arm.links, 3), "rad");
    return text;
  }

 public:
  KinematicCalibration() {
    on<CalibrateKinematics>([this](const CalibrateKinematics& order) { calibrate(order); });
  }
};

}  // namespace
}  // namespace mrroc::calibration

MRROC_ECP(mrroc::calibration::KinematicCalibration)
