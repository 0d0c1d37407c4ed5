#include "calibration/hand_eye.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "calibration/as_computed.hpp"
#include "calibration/outlying_views.hpp"
#include "calibration/seeded.hpp"
#include "calibration/view_postures.hpp"
#include "kinematics/measured_chain.hpp"
#include "kinematics/measured_joints.hpp"
#include "mrroc/errors.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::calibration {
namespace {

const RobotModel& irb6() {
  static const RobotModels models = load_irb6();
  return *models.front();
}

/// The true camera, marker, focal length and joints, and views of them.
struct Scene {
  HandEyeFit truth;
  std::vector<MarkerView> views;
};

struct Noise {
  double corner = 0;                    // rad
  double focal = 0, k1 = 0, joint = 0;  // sizes of the errors
  double link = 0;                      // m and rad
  double gear = 0;                      // rad
  double play = 0;                      // rad: half of it
};

constexpr double kSide = 0.09;  // m

Eigen::Matrix<double, 2, 4> corners_of(const Pose& marker) {
  Eigen::Matrix<double, 2, 4> corners;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d p =
        marker * Eigen::Vector3d(i < 2 ? kSide / 2 : -kSide / 2, i % 2 != 0 ? kSide / 2 : -kSide / 2, 0);
    corners.col(i) = p.head<2>() / p.z();
  }
  return corners;
}

/// The pose that explains the corners of a marker in these directions best, near `pose`.
Pose seen_pose(const Eigen::Matrix<double, 2, 4>& corners, Pose pose) {
  const auto moved = [&pose](const Eigen::Matrix<double, 6, 1>& x) {
    Pose result = pose;
    result.translation() += x.head<3>();
    result.linear() = pose.linear() * exp_rotation(x.tail<3>());
    return result;
  };
  for (int iteration = 0; iteration < 8; ++iteration) {  // Gauss-Newton
    Eigen::Matrix<double, 8, 6> jacobian;
    for (int i = 0; i < 6; ++i) {
      const Eigen::Matrix<double, 6, 1> step = 1e-6 * Eigen::Matrix<double, 6, 1>::Unit(i);
      jacobian.col(i) = (corners_of(moved(step)) - corners_of(moved(-step))).reshaped() / 2e-6;
    }
    const Eigen::Matrix<double, 8, 1> difference = (corners - corners_of(pose)).reshaped();
    pose = moved(jacobian.colPivHouseholderQr().solve(difference));
  }
  return pose;
}

/// The flange of an arm with these links.
Pose flange_of(const JointVector& joints, const std::vector<Twist>& links) {
  return links.empty() ? irb6().flange(joints) : kinematics::measured_chain(irb6(), links).flange(joints);
}

/// The marker in the camera frame.
Pose seen_from(const JointVector& joints, const HandEyeFit& truth) {
  const Pose flange = flange_of(joints, truth.arm.links);
  const Pose carrier = truth.carried == Carried::camera ? flange : flange.inverse();
  return (carrier * truth.camera).inverse() * truth.marker;
}

Scene scene(std::uint32_t seed, const Noise& noise, Carried carried = Carried::camera, std::size_t views = 20,
            const ViewCap& cap = {}) {
  Seeded random(seed);
  const JointVector home = irb6().parameters().home;
  Scene made;
  HandEyeFit& truth = made.truth;
  truth.carried = carried;
  truth.camera = Eigen::Translation3d(Eigen::Vector3d(0.08, 0, 0.06) + random.vector(0.01)) *
                 Pose(exp_rotation(random.vector(0.1) + Eigen::Vector3d(0, 0, 1.6)));
  truth.marker = irb6().flange(home) * truth.camera * Pose(Eigen::Translation3d(0.02, 0.01, 0.4)) *
                 Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
  if (carried == Carried::marker) {
    truth.marker = Eigen::Translation3d(Eigen::Vector3d(0.02, 0, 0.2) + random.vector(0.01)) *
                   Pose(exp_rotation(random.vector(0.1)));
    truth.camera = irb6().flange(home) * truth.marker * Pose(Eigen::Translation3d(0.02, 0.01, 0.4)) *
                   Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
  }
  truth.focal = random.within(noise.focal);
  truth.k1 = random.within(noise.k1);
  truth.arm.zeros = JointVector::Zero(home.size());
  for (double& joint : truth.arm.zeros) joint = random.within(noise.joint);
  truth.play = JointVector::Zero(home.size());
  if (noise.play > 0)
    for (double& half : truth.play) half = std::abs(random.within(noise.play));
  if (noise.link > 0)
    for (Eigen::Index i = 0; i < home.size(); ++i)
      truth.arm.links.emplace_back() << random.vector(noise.link), random.vector(noise.link);
  if (noise.gear > 0)
    for (Eigen::Index i = 0; i < home.size(); ++i) truth.arm.gears.emplace_back(random.vector(noise.gear));
  for (const JointVector& joints : view_postures(irb6(), truth, home, views, cap)) {
    MarkerView view;
    view.approach = made.views.size() % 2 == 0 ? 1 : -1;
    view.joints = kinematics::MeasuredJoints(truth.arm, 6).encoders(joints) + view.approach * truth.play;
    view.side = kSide;
    const Pose marker = seen_from(joints, truth);
    Eigen::Matrix<double, 2, 4> corners = corners_of(marker);
    for (int i = 0; i < 4; ++i) {
      corners.col(i) *= (1 + truth.focal) * (1 + truth.k1 * corners.col(i).squaredNorm());
      corners.col(i) += random.noise(noise.corner).head<2>();
    }
    view.marker = seen_pose(corners, marker);
    made.views.push_back(view);
  }
  return made;
}

double distance(const Pose& a, const Pose& b) { return (a.translation() - b.translation()).norm(); }
double angle(const Pose& a, const Pose& b) { return rotation_vector(a.linear().transpose() * b.linear()).norm(); }

Carried carried_of(bool marker) { return marker ? Carried::marker : Carried::camera; }

RC_GTEST_PROP(HandEye, ClosedFormIsExactWithoutErrors, (std::uint32_t seed, bool marker)) {
  const Scene made = scene(seed, {}, carried_of(marker));
  const HandEyeFit fit = closed_form_hand_eye(irb6(), made.views, carried_of(marker));
  RC_ASSERT(distance(fit.camera, made.truth.camera) < 1e-8);
  RC_ASSERT(angle(fit.camera, made.truth.camera) < 1e-6);
  RC_ASSERT(distance(fit.marker, made.truth.marker) < 1e-8);
}

RC_GTEST_PROP(HandEye, FindsTheFocalLengthToo, (std::uint32_t seed)) {
  const Scene made = scene(seed, {.focal = 0.003});
  // of an arm that is known exactly
  const HandEyeFit fit = fit_hand_eye(irb6(), made.views, {.joint = 1e-7, .focal = 0.1, .position = 0, .rotation = 0});
  RC_ASSERT(distance(fit.camera, made.truth.camera) < 5e-5);
  RC_ASSERT(std::abs(fit.focal - made.truth.focal) < 1e-4);
}

// errors of an arm that was not calibrated, and of a picture
RC_GTEST_PROP(HandEye, ErrorsFollowTheDeviations, (std::uint32_t seed, bool marker)) {
  const Scene made = scene(seed, {.corner = 1e-4, .focal = 0.003, .k1 = 0.01, .joint = 0.0005}, carried_of(marker));
  const HandEyeFit fit = fit_hand_eye(irb6(), made.views, {}, carried_of(marker));
  RC_ASSERT(distance(fit.camera, made.truth.camera) < 6 * fit.position_deviation);
  RC_ASSERT(angle(fit.camera, made.truth.camera) < 6 * fit.rotation_deviation);
  RC_ASSERT(std::abs(fit.focal - made.truth.focal) < 6 * fit.focal_deviation);
  RC_ASSERT(distance(fit.marker, made.truth.marker) < 6 * fit.marker_position_deviation);
  RC_ASSERT(angle(fit.marker, made.truth.marker) < 6 * fit.marker_rotation_deviation);
}

TEST(HandEye, RefinementIsBetterThanTheClosedForm) {
  double closed = 0, refined = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Scene made = scene(seed, {.corner = 2e-4, .focal = 0.003, .k1 = 0.01, .joint = 0.0005});
    closed += distance(closed_form_hand_eye(irb6(), made.views).camera, made.truth.camera) / 20;
    refined += distance(fit_hand_eye(irb6(), made.views).camera, made.truth.camera) / 20;
  }
  std::printf("mean error of the position: %.3f mm in closed form, %.3f mm refined\n", 1000 * closed, 1000 * refined);
  EXPECT_LT(refined, 0.5 * closed);
}

/// The largest error of the camera's place beside the marker at the postures of `views`, m, with all as estimated.
double error_of_places(const std::vector<MarkerView>& views, const HandEyeFit& fit, const HandEyeFit& truth) {
  double worst = 0;
  for (const MarkerView& view : views) {
    const auto place = [&view](const HandEyeFit& arm) {
      const JointVector joints = kinematics::MeasuredJoints(arm.arm, 6).joints(view.joints) - view.approach * arm.play;
      return Pose(arm.marker.inverse() * flange_of(joints, arm.arm.links) * arm.camera);
    };
    worst = std::max(worst, distance(place(fit), place(truth)));
  }
  return worst;
}

std::vector<MarkerView> every_second(const std::vector<MarkerView>& views, std::size_t first) {
  std::vector<MarkerView> chosen;
  for (std::size_t k = first; k < views.size(); k += 2) chosen.push_back(views[k]);
  return chosen;
}

RC_GTEST_PROP(HandEye, FindsZerosAndLinksOfAnArm, (std::uint32_t seed)) {
  const ViewCap wide{.tilt = 0.6, .turn = 1.5, .nearest = 0.9, .farthest = 1.7, .joint_reach = 2.5};
  const Scene made = scene(seed, {.corner = 5e-5, .joint = 0.004, .link = 0.001}, Carried::camera, 100, wide);
  const std::vector<MarkerView> seen = every_second(made.views, 0), others = every_second(made.views, 1);
  HandEyePriors measured{.joint = 0.004, .position = 2e-5, .rotation = 4e-5}, nominal = measured;
  measured.link_position = measured.link_rotation = 0.001;
  nominal.joint = 1e-9;
  const HandEyeFit fit = fit_hand_eye(irb6(), seen, measured);
  const double before = error_of_places(others, fit_hand_eye(irb6(), seen, nominal), made.truth);
  const double after = error_of_places(others, fit, made.truth);
  RC_LOG() << made.views.size() << " views, " << 1000 * before << " mm before, " << 1000 * after << " mm after\n";
  RC_ASSERT(fit.arm.links.size() == 6U);
  RC_ASSERT(after < 0.0007);
  RC_ASSERT(after < 0.35 * before);
}

RC_GTEST_PROP(HandEye, FindsTheGearsOfAnArm, (std::uint32_t seed)) {
  const Scene made = scene(seed, {.corner = 2e-5, .joint = 0.001, .gear = 0.002}, Carried::camera, 100);
  const std::vector<MarkerView> seen = every_second(made.views, 0), others = every_second(made.views, 1);
  HandEyePriors zeros{.joint = 0.001, .position = 1e-5, .rotation = 2e-5}, gears = zeros;
  gears.gear = 0.002;
  const HandEyeFit fit = fit_hand_eye(irb6(), seen, gears);
  const double before = error_of_places(others, fit_hand_eye(irb6(), seen, zeros), made.truth);
  const double after = error_of_places(others, fit, made.truth);
  RC_LOG() << made.views.size() << " views, " << 1000 * before << " mm before, " << 1000 * after << " mm after\n";
  RC_ASSERT(fit.arm.gears.size() == 6U);
  RC_ASSERT(after < 0.0003);
  RC_ASSERT(after < 0.5 * before);
}

RC_GTEST_PROP(HandEye, FindsThePlayOfAnArm, (std::uint32_t seed)) {
  const Scene made = scene(seed, {.corner = 2e-5, .joint = 0.0005, .play = 0.0005}, Carried::camera, 60);
  const HandEyePriors exact{.joint = 0.0005, .position = 2e-6, .rotation = 4e-6, .play = 0.0005};
  const HandEyeFit fit = fit_hand_eye(irb6(), made.views, exact);
  std::vector<MarkerView> one_sided = made.views;
  for (MarkerView& view : one_sided) view.approach = 0;
  const HandEyeFit without = fit_hand_eye(irb6(), one_sided, exact);
  RC_LOG() << "play " << made.truth.play.transpose() << ", found " << fit.play.transpose() << "\n";
  RC_ASSERT((fit.play - made.truth.play).cwiseAbs().maxCoeff() < 5e-5);
  RC_ASSERT(without.play.isZero(1e-12));
  RC_ASSERT(distance(fit.camera, made.truth.camera) < 6 * fit.position_deviation);
}

TEST(HandEye, ErrorsOfAnArmStayInThePoseThatItsModelNeeds) {
  double of_the_arm = 0, computed = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Scene made = scene(seed, {.corner = 2e-5, .joint = 0.0005, .link = 0.0003}, Carried::camera, 40);
    const HandEyeFit whole = fit_hand_eye(irb6(), made.views, whole_arm_priors());
    const Pose wanted = as_computed(irb6(), made.views, made.truth).camera;
    of_the_arm += distance(whole.camera, wanted) / 20;
    computed += distance(as_computed(irb6(), made.views, whole).camera, wanted) / 20;
  }
  std::printf("mean error of the position: %.3f mm, as computed %.3f mm\n", 1000 * of_the_arm, 1000 * computed);
  EXPECT_LT(computed, 0.0001);
  EXPECT_LT(computed, 0.3 * of_the_arm);
}

RC_GTEST_PROP(HandEye, ViewsThatContradictTheOthersAreLeftOut, (std::uint32_t seed, bool marker)) {
  Scene made = scene(seed, {.corner = 1e-4, .focal = 0.003}, carried_of(marker));
  const std::size_t first = seed % made.views.size(), second = (first + 7) % made.views.size();
  made.views[first].marker.translation().x() += 0.01;
  made.views[second].marker.linear() *= exp_rotation(Eigen::Vector3d(0.6, 0, 0));
  const AgreedFit agreed = fit_of_agreeing_views(irb6(), made.views, {}, carried_of(marker));
  RC_ASSERT(agreed.used.size() + agreed.left_out.size() == made.views.size());
  RC_ASSERT(agreed.fit.residuals.size() == agreed.used.size());
  for (const std::size_t wrong : {first, second})
    RC_ASSERT(std::count(agreed.left_out.begin(), agreed.left_out.end(), wrong) == 1);
  RC_ASSERT(distance(agreed.fit.camera, made.truth.camera) < 6 * agreed.fit.position_deviation);
}

TEST(HandEye, AFifthOfTheViewsIsLeftOutAtMost) {
  Scene made = scene(5, {.corner = 1e-4});
  for (std::size_t k = 0; k < made.views.size(); k += 2)
    made.views[k].marker.translation().y() += 0.002 * static_cast<double>(k);
  const AgreedFit agreed = fit_of_agreeing_views(irb6(), made.views, {});
  EXPECT_LE(5 * agreed.left_out.size(), made.views.size());
  EXPECT_GT(*std::max_element(agreed.fit.residuals.begin(), agreed.fit.residuals.end()), 1e-3);
}

TEST(HandEye, RefusesViewsThatDoNotDefineAPose) {
  Scene made = scene(3, {});
  made.views.resize(2);
  EXPECT_THROW(fit_hand_eye(irb6(), made.views), NonFatalError);
  made = scene(3, {});
  for (MarkerView& view : made.views) {  // the last joint alone
    const double last = view.joints[5];
    view.joints = irb6().parameters().home;
    view.joints[5] = last;
    view.marker = (irb6().flange(view.joints) * made.truth.camera).inverse() * made.truth.marker;
  }
  EXPECT_THROW(fit_hand_eye(irb6(), made.views), NonFatalError);
}

}  // namespace
}  // namespace mrroc::calibration
