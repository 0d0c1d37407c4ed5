#include "mrroc/generators/image_servo.hpp"

#include <cmath>
#include <limits>

#include "geometry/least_norm.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/servoing/visual_servo.hpp"

namespace mrroc {

namespace {

constexpr int kRows = 2 * kMaxImagePoints;
using Interaction = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::ColMajor, kRows, 6>;
using Features = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kRows, 1>;

}  // namespace

Eigen::Matrix<double, 2, 6> point_interaction(double x, double y, double depth) noexcept {
  Eigen::Matrix<double, 2, 6> matrix;
  matrix << -1 / depth, 0, x / depth, x * y, -(1 + x * x), y,  //
      0, -1 / depth, y / depth, 1 + y * y, -x * y, -x;
  return matrix;
}

ImageServo::ImageServo(Robot& robot, Points points, const ImagePoints& wanted, const ImageDepths& depths,
                       const Pose& camera, const ServoLimits& limits, double tolerance)
    : Generator("ImageServo"),
      points_(std::move(points)),
      wanted_(wanted),
      depths_(depths),
      camera_(camera),
      tolerance_(tolerance),
      servo_(std::make_unique<VisualServo>(robot, limits, "ImageServo")) {
  const auto refuse = [](const std::string& what) {
    throw NonFatalError(ErrorCode::invalid_argument, "ImageServo: " + what);
  };
  if (!points_) refuse("no function for the points");
  if (wanted.cols() < 3) refuse(std::to_string(wanted.cols()) + " points, expected 3 to 8");
  if (!wanted.allFinite()) refuse("a desired point is not finite");
  if (depths.cols() != wanted.cols())
    refuse(std::to_string(depths.cols()) + " depths, expected " + std::to_string(wanted.cols()));
  if (!depths.allFinite() || depths.minCoeff() <= 0) refuse("a depth that is not above 0");
  if (!is_rigid(camera)) refuse("the camera's pose is not rigid");
  if (!(tolerance > 0)) refuse("tolerance " + std::to_string(tolerance) + ", expected above 0");
}

ImageServo::~ImageServo() = default;
ImageServo::ImageServo(ImageServo&&) noexcept = default;
ImageServo& ImageServo::operator=(ImageServo&&) noexcept = default;

void ImageServo::start() { servo_->start(); }

double ImageServo::error() const noexcept {
  if (!seen_ || seen_->cols() != wanted_.cols()) return std::numeric_limits<double>::quiet_NaN();
  return (*seen_ - wanted_).colwise().norm().maxCoeff();
}

bool ImageServo::terminal_condition() {
  seen_ = points_();
  if (seen_ && !seen_->allFinite()) seen_.reset();
  return error() <= tolerance_ && servo_->at_rest();
}

void ImageServo::next_state() {
  if (!seen_) return servo_->step(std::nullopt);
  if (seen_->cols() != wanted_.cols()) {
    throw NonFatalError(ErrorCode::invalid_argument, "ImageServo: " + std::to_string(seen_->cols()) +
                                                         " points are visible, expected " +
                                                         std::to_string(wanted_.cols()));
  }
  if (error() <= tolerance_) return servo_->step(Twist::Zero());
  const Eigen::Index count = wanted_.cols();
  Interaction matrix(2 * count, 6);
  Features error(2 * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    matrix.middleRows<2>(2 * i) = point_interaction((*seen_)(0, i), (*seen_)(1, i), depths_[i]);
    error.segment<2>(2 * i) = seen_->col(i) - wanted_.col(i);
  }
  const Twist camera = -servo_->gain() * least_norm_solution(matrix, error);
  Twist tool = rotate_twist(camera_.linear(), camera);
  tool.head<3>() -= tool.tail<3>().cross(camera_.translation());
  servo_->step(tool);
}

}  // namespace mrroc
