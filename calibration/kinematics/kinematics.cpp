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

namespace mrroc::calibration {
namespace {

constexpr std::size_t kKeptOut = 5;  // every fifth view
constexpr double kExact = 1e-9;      // rad or m: of joints that are not estimated
// the ranges of the keys
constexpr double kLargestZero = 0.2, kLargestPosition = 0.05, kLargestRotation = 0.1;  // rad or m; m; rad

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

/// Of three numbers of each link, from number `from` of its six on.
double largest(const std::vector<Twist>& links, Eigen::Index from) {
  double largest = 0;
  for (const Twist& link : links) largest = std::max(largest, link.segment<3>(from).cwiseAbs().maxCoeff());
  return largest;
}

/// Three numbers of each link, from number `from` of its six on.
std::string toml_rows(const std::vector<Twist>& links, Eigen::Index from) {
  Eigen::VectorXd numbers(3 * std::ssize(links));
  for (std::size_t i = 0; i < links.size(); ++i)
    numbers.segment<3>(3 * static_cast<Eigen::Index>(i)) = links[i].segment<3>(from);
  return toml_list(rounded(numbers));
}

/// Finds the zeros of the joints and the places of the axes by looking at a marker from many sides.
class KinematicCalibration : public ecp::Task {
  AnyRobot arm{*this};
  MarkerViews marker{*this, arm};

  void calibrate(const CalibrateKinematics& order) {
    const config::RobotEntry& entry = process().deployment().robot(arm.name());
    const RobotModels models = load_models(entry.type, entry.files().parameters);  // not as measured before
    const RobotModel& model = *models.front();
    const bool with_links = model.joint_count() == 6 && order.link_deviation > 0;
    if (with_links) kinematics::measured_chain(model);  // refused before anything moves
    ViewOrder view_order = calibration::view_order(order);
    view_order.cap = {.tilt = 0.6, .turn = 1.5, .nearest = 0.9, .farthest = 1.7, .joint_reach = 2.5};
    std::vector<MarkerView> views = marker.take(view_order);
    if (entry.measured_arm.zeros.size() != 0)
      for (MarkerView& view : views) view.joints -= entry.measured_arm.zeros;  // what the encoders say

    HandEyePriors nominal = view_order.priors, measured = view_order.priors;
    nominal.joint = kExact;
    if (with_links) measured.link_position = measured.link_rotation = order.link_deviation;
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
    const std::vector<Bound> bounds{{"residual", "rad", residual, order.residual_bound},
                                    {"residual of views kept out", "rad", after, 1.1 * before},
                                    {"largest zero", "rad", agreed.fit.joints.cwiseAbs().maxCoeff(), kLargestZero},
                                    {"largest link", "m", largest(agreed.fit.links, 0), kLargestPosition},
                                    {"largest turn of a link", "rad", largest(agreed.fit.links, 3), kLargestRotation}};
    judge(bounds);
    write_calibration(std::string(order.into.view()), "kinematics", "robot '" + arm.name() + "'", bounds,
                      text_of(agreed.fit));
  }

  static void print(const HandEyeFit& fit) {
    for (Eigen::Index i = 0; i < fit.joints.size(); ++i) {
      std::printf("axis %td: zero %.5f rad", i + 1, rounded(fit.joints)[i]);
      if (!fit.links.empty()) {
        const Twist link = 1000 * rounded(fit.links[static_cast<std::size_t>(i)]);
        std::printf(", link (%.3f, %.3f, %.3f) mm, (%.3f, %.3f, %.3f) mrad", link[0], link[1], link[2], link[3],
                    link[4], link[5]);
      }
      std::printf("\n");
    }
    std::printf("zeros +- %.5f rad at most\n", fit.joint_deviation);
  }

  std::string text_of(const HandEyeFit& fit) const {
    std::string text =
        "[robots." + arm.name() + "]\njoint_zeros = " + toml_list(rounded(fit.joints)) + "  # rad or m\n";
    if (!fit.links.empty())
      text += "link_positions = " + toml_rows(fit.links, 0) +
              "  # m, of each axis\nlink_rotations = " + toml_rows(fit.links, 3) + "  # rad\n";
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
