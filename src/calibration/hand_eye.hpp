#pragma once

#include <vector>

#include "mrroc/measured_arm.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::calibration {

/// What a robot's flange carries; the other of the two does not move.
enum class Carried { camera, marker };

/// One picture of a square marker.
struct MarkerView {
  JointVector joints;              ///< of the robot, rad or m
  Pose marker = Pose::Identity();  ///< in the camera frame (z along the view, x right, y down), its middle
  double side = 0;                 ///< of its square, m
  int approach = 0;  ///< 1: every joint has come up to its position, -1: down; 0: its play is in the middle
};

/// Standard deviations of what is estimated beside the camera's pose, before the views.
struct HandEyePriors {
  double joint = 0.0003;   ///< rad or m: encoder reading at each joint's zero
  double focal = 0.003;    ///< 1: relative error of the focal length
  double k1 = 0.01;        ///< 1: radial distortion of the lens
  double position = 1e-4;  ///< m: of the flange, beyond the joints' zeros, from posture to posture
  double rotation = 2e-4;  ///< rad
  double corner = 5e-5;    ///< rad: of a corner in the picture
  /// Of the links, m and rad: of each coordinate of MeasuredArm::links. Both 0: the links are those of the model.
  double link_position = 0, link_rotation = 0;
  double gear = 0;     ///< rad: of each number of MeasuredArm::gears. 0: the gears are those of the model
  double play = 2e-4;  ///< rad or m: of HandEyeFit::play

  bool estimate_links() const noexcept { return link_position > 0 && link_rotation > 0; }
};

/// Those of an arm whose joints' zeros have this deviation (rad or m), and its flange `arm` (m; twice as many rad).
HandEyePriors arm_priors(double joint, double arm) noexcept;

/// Of an arm that may differ from its type in all that can be estimated: zeros by 1 mrad, links by 0.3 mm and 0.3 mrad,
/// gears by 0.2 mrad; with pictures that are the mean of several.
HandEyePriors whole_arm_priors() noexcept;

/// Where camera and marker are, and everything that the estimation needs.
struct HandEyeFit {
  Carried carried = Carried::camera;
  Pose camera = Pose::Identity();  ///< X: the camera frame in the flange frame; in the base frame if it does not move
  Pose marker = Pose::Identity();  ///< Z: the marker in the base frame; in the flange frame if it is carried
  double focal = 0;                ///< e: the true focal length is (1 + e) times that of the readings
  double k1 = 0;                   ///< of the lens, beyond that of the readings
  MeasuredArm arm;                 ///< d, its zeros; its gears and links are empty when they are not estimated
  /// b, rad or m: half of what the side of the approach changes at each joint; half its play where the side alone
  /// decides where the joint stands.
  JointVector play;
  double position_deviation = 0;  ///< standard deviation of X in its worst direction, m
  double rotation_deviation = 0;  ///< rad
  double focal_deviation = 0;
  double joint_deviation = 0;            ///< of the element of d that the views say least about, rad or m
  double marker_position_deviation = 0;  ///< of Z, as of X
  double marker_rotation_deviation = 0;
  std::vector<double> residuals;  ///< of each view: root mean square of its corners' directions, rad
};

/// X and Z in closed form (Park and Martin, "Robot sensor calibration: solving AX = XB on the Euclidean group", IEEE
/// Trans. Robotics and Automation 10(5), 1994): with F_k = flange(q_k), or its inverse where the flange carries the
/// marker, and B_k the marker in the camera frame, F_k X B_k = Z for all k; e, k1 and d are 0. Throws
/// NonFatalError(invalid_argument): fewer than three views, or turns of the flange about one axis only. Any thread;
/// allocates.
HandEyeFit closed_form_hand_eye(const RobotModel& model, const std::vector<MarkerView>& views,
                                Carried carried = Carried::camera);

/// The maximum a-posteriori estimate of X, Z, e, k1, the arm's zeros d and what play changes, b. View k shows the
/// corner c of the marker,
/// (+-side, +-side, 0) / 2, in the direction u = h(B_k c), h(x, y, z) = (x, y) / z; the model expects it in
///
///   u = (1 + e) (1 + k1 |w|^2) w,   w = h((F(q_k + d - a_k b) X)^-1 Z c),   q_k the encoders' readings
///
/// with a_k the view's `approach`: with views from both sides the zeros are those of the middle of the play. Minimised
/// are the squares of the differences, weighed by their covariance, and of e, k1, d and b over their priors,
/// from the closed form by Levenberg-Marquardt (Eigen's port of MINPACK). The covariance of the four corners of a view
/// is that of the picture and of the flange's pose: corner^2 I + J diag(position^2, rotation^2) J^T, J their derivative
/// by the marker's pose in the camera frame. So an arm that is not exact costs no accuracy of depth and tilt. An error
/// of the focal length, left out, would appear as one of the depth. Gears (`kinematics::MeasuredJoints`) and, with
/// `estimate_links`, the links of the chain (`kinematics::measured_chain`) are estimated in the same manner as d; what
/// no view shows stays 0. The covariance of the result is that of these weights, times the mean square of the weighed
/// differences, at least kLeastVariance.
///
/// Throws as `closed_form_hand_eye`; NonFatalError(invalid_argument) when the iteration does not converge;
/// SystemError(configuration): links of a model that is no chain of its joints.
HandEyeFit fit_hand_eye(const RobotModel& model, const std::vector<MarkerView>& views, const HandEyePriors& priors = {},
                        Carried carried = Carried::camera);

inline constexpr double kLeastVariance = 0.1;

/// The marker of a view in the camera frame, as `fit` expects it. Any thread.
Pose expected_marker(const RobotModel& model, const HandEyeFit& fit, const MarkerView& view);

/// Root mean square of the differences between where a view shows the corners and where `fit` expects them, rad. Any
/// thread.
double residual_of(const RobotModel& model, const HandEyeFit& fit, const MarkerView& view);

}  // namespace mrroc::calibration
