#include "calibration/hand_eye.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <string>
#include <unsupported/Eigen/NonLinearOptimization>

#include "geometry/rigid_motion.hpp"
#include "kinematics/measured_chain.hpp"
#include "kinematics/measured_joints.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::calibration {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStep = 1e-6;       // m, rad or 1, of the derivatives
constexpr double kNone = 1e-12;      // rad
constexpr double kLeastAxes = 0.02;  // of the smaller rotations, rad: their axes differ

/// X of A_j X = X B_j by Park and Martin.
Pose park_martin(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  Matrix3d m = Matrix3d::Zero(), axes = Matrix3d::Zero();
  for (std::size_t j = 0; j < a.size(); ++j) {
    const Vector3d alpha = rotation_vector(a[j].linear()), beta = rotation_vector(b[j].linear());
    m += beta * alpha.transpose();
    axes += alpha * alpha.transpose() / static_cast<double>(a.size());
  }
  const double second = Eigen::SelfAdjointEigenSolver<Matrix3d>(axes, Eigen::EigenvaluesOnly).eigenvalues()[1];
  if (!(std::sqrt(std::max(second, 0.0)) > kLeastAxes))
    throw NonFatalError(ErrorCode::invalid_argument,
                        "the flange has turned about one axis only, expected views from turns about two or more");
  // (M^T M)^(-1/2) M^T is the rotation nearest to M^T
  Eigen::JacobiSVD<Matrix3d> svd(m.transpose(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3d sign = Matrix3d::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  Pose x = Pose::Identity();
  x.linear() = svd.matrixU() * sign * svd.matrixV().transpose();
  Eigen::MatrixXd left(3 * static_cast<Index>(a.size()), 3);
  VectorXd right(left.rows());
  for (std::size_t j = 0; j < a.size(); ++j) {
    const auto row = 3 * static_cast<Index>(j);
    left.block<3, 3>(row, 0) = a[j].linear() - Matrix3d::Identity();
    right.segment<3>(row) = x.linear() * b[j].translation() - a[j].translation();
  }
  x.translation() = left.colPivHouseholderQr().solve(right);
  return x;
}

/// F of a posture with this flange.
Pose moved_part(const Pose& flange, Carried carried) { return carried == Carried::camera ? flange : flange.inverse(); }

/// The arm as estimated.
class EstimatedArm {
 public:
  EstimatedArm(const RobotModel& model, const HandEyeFit& fit)
      : model_(model), carried_(fit.carried), play_(fit.play), joints_(fit.arm, model.joint_count()) {
    if (!fit.arm.links.empty()) chain_ = kinematics::measured_chain(model, fit.arm.links);
  }
  /// The marker of a view in the camera frame.
  Pose marker_at(const HandEyeFit& fit, const MarkerView& view) const {
    return (part_at(view) * fit.camera).inverse() * fit.marker;
  }

 private:
  /// F at the encoders' readings of a view.
  Pose part_at(const MarkerView& view) const {
    const JointVector joints = joints_.joints(view.joints) - view.approach * play_;
    return moved_part(chain_ ? chain_->flange(joints) : model_.flange(joints), carried_);
  }

  const RobotModel& model_;
  const Carried carried_;
  const JointVector play_;
  const kinematics::MeasuredJoints joints_;
  std::optional<kinematics::SerialChain> chain_;
};

using Corners = Eigen::Matrix<double, 2, 4>;

/// Directions of the corners of a marker of this side at `marker` in the camera frame.
Corners directions(const Pose& marker, double side) {
  Corners directions;
  for (int i = 0; i < 4; ++i) {
    const Vector3d corner = marker * Vector3d(i < 2 ? side / 2 : -side / 2, i % 2 != 0 ? side / 2 : -side / 2, 0);
    directions.col(i) = corner.head<2>() / corner.z();
  }
  return directions;
}

using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// The inverse of the Cholesky factor of the covariance of a view's corners.
Matrix8 weight_of(const MarkerView& view, const HandEyePriors& priors, Carried carried) {
  Eigen::Matrix<double, 8, 6> derivative;
  for (int i = 0; i < 6; ++i) {
    const auto moved = [&](double step) {
      Pose marker = view.marker;
      if (i < 3) {
        marker.translation()[i] += step;
        return directions(marker, view.side);
      }
      // the flange turns near what it carries
      const Matrix3d turn = exp_rotation(step * Vector3d::Unit(i - 3));
      if (carried == Carried::camera) marker.translation() = turn * marker.translation();
      marker.linear() = turn * marker.linear();
      return directions(marker, view.side);
    };
    derivative.col(i) =
        (moved(kStep) - moved(-kStep)).reshaped() / (2 * kStep) * (i < 3 ? priors.position : priors.rotation);
  }
  const Matrix8 covariance = derivative * derivative.transpose() + priors.corner * priors.corner * Matrix8::Identity();
  return covariance.llt().matrixL().solve(Matrix8::Identity());
}

/// Parameters: X and Z as increments (translation, rotation vector) of their starts, e, k1, d, b, then gears and links.
struct Problem {
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const RobotModel* model;
  const std::vector<MarkerView>* views;
  HandEyePriors priors;
  Carried carried;
  Pose camera, marker;           // the starts
  std::vector<Matrix8> weights;  // of each view: difference^T W^T W difference

  int joints() const { return model->joint_count(); }
  int gears() const { return priors.gear > 0 ? 3 * joints() : 0; }
  int links() const { return priors.estimate_links() ? 6 * joints() : 0; }
  int inputs() const { return 14 + 2 * joints() + gears() + links(); }
  int values() const { return 8 * static_cast<int>(views->size()) + inputs() - 12; }

  static Pose moved(const Pose& start, const VectorXd& x, Index from) {
    Pose pose = start;
    pose.translation() += x.segment<3>(from);
    pose.linear() = start.linear() * exp_rotation(x.segment<3>(from + 3));
    return pose;
  }
  HandEyeFit at(const VectorXd& x) const {
    HandEyeFit fit;
    fit.carried = carried;
    fit.camera = moved(camera, x, 0);
    fit.marker = moved(marker, x, 6);
    fit.focal = x[12];
    fit.k1 = x[13];
    fit.arm.zeros = x.segment(14, joints());
    fit.play = x.segment(14 + joints(), joints());
    Index from = 14 + 2 * joints();
    for (; from < x.size() - links(); from += 3) fit.arm.gears.emplace_back(x.segment<3>(from));
    for (; from < x.size(); from += 6) fit.arm.links.emplace_back(x.segment<6>(from));
    return fit;
  }
  static Corners difference(const EstimatedArm& arm, const HandEyeFit& fit, const MarkerView& view) {
    Corners seen = directions(arm.marker_at(fit, view), view.side);
    for (int i = 0; i < 4; ++i) seen.col(i) *= (1 + fit.focal) * (1 + fit.k1 * seen.col(i).squaredNorm());
    return seen - directions(view.marker, view.side);
  }
  int operator()(const VectorXd& x, VectorXd& residuals) const {
    const HandEyeFit fit = at(x);
    const EstimatedArm arm(*model, fit);
    Index row = 0;
    for (const MarkerView& view : *views) {
      residuals.segment<8>(row) = weights[static_cast<std::size_t>(row / 8)] * difference(arm, fit, view).reshaped();
      row += 8;
    }
    residuals[row] = fit.focal / priors.focal;
    residuals[row + 1] = fit.k1 / priors.k1;
    residuals.segment(row + 2, joints()) = fit.arm.zeros / priors.joint;
    residuals.segment(row + 2 + joints(), joints()) = fit.play / priors.play;
    row += 2 + 2 * joints();
    for (int axis = 0; axis < std::ssize(fit.arm.gears); ++axis, row += 3) {
      const double round = model->joint_period(axis) > 0 ? priors.gear : kNone;  // a sliding axis has no eccentricity
      residuals.segment<3>(row) =
          fit.arm.gears[static_cast<std::size_t>(axis)].cwiseQuotient(Vector3d(priors.gear, round, round));
    }
    for (const Twist& link : fit.arm.links) {
      residuals.segment<3>(row) = link.head<3>() / priors.link_position;
      residuals.segment<3>(row + 3) = link.tail<3>() / priors.link_rotation;
      row += 6;
    }
    return 0;
  }
  /// By central differences.
  int df(const VectorXd& x, Eigen::MatrixXd& jacobian) const {
    VectorXd shifted = x, above(values()), below(values());
    for (Index i = 0; i < x.size(); ++i) {
      shifted[i] = x[i] + kStep;
      (*this)(shifted, above);
      shifted[i] = x[i] - kStep;
      (*this)(shifted, below);
      shifted[i] = x[i];
      jacobian.col(i) = (above - below) / (2 * kStep);
    }
    return 0;
  }
};

void minimise(Problem& problem, VectorXd& x) {
  Eigen::LevenbergMarquardt<Problem> solver(problem);
  const auto status = solver.minimize(x);
  if (status == Eigen::LevenbergMarquardtSpace::ImproperInputParameters ||
      status == Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation || !x.allFinite())
    throw NonFatalError(ErrorCode::invalid_argument, "the estimate of the camera's pose does not converge from " +
                                                         std::to_string(problem.views->size()) + " views");
}

/// Square root of the largest eigenvalue.
double worst(const Matrix3d& covariance) {
  return std::sqrt(
      std::max(Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance, Eigen::EigenvaluesOnly).eigenvalues()[2], 0.0));
}

}  // namespace

HandEyeFit closed_form_hand_eye(const RobotModel& model, const std::vector<MarkerView>& views, Carried carried) {
  if (views.size() < 3)
    throw NonFatalError(ErrorCode::invalid_argument,
                        std::to_string(views.size()) + " views of the marker, expected at least 3");
  std::vector<Pose> a, b;
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t j = i + 1; j < views.size(); ++j) {
      a.push_back(moved_part(model.flange(views[j].joints), carried).inverse() *
                  moved_part(model.flange(views[i].joints), carried));
      b.push_back(views[j].marker * views[i].marker.inverse());
    }
  }
  HandEyeFit fit;
  fit.carried = carried;
  fit.arm.zeros = fit.play = JointVector::Zero(model.joint_count());
  fit.camera = park_martin(a, b);
  Vector3d position = Vector3d::Zero();
  Matrix3d rotation = Matrix3d::Zero();
  for (const MarkerView& view : views) {
    const Pose marker = moved_part(model.flange(view.joints), carried) * fit.camera * view.marker;
    position += marker.translation() / static_cast<double>(views.size());
    rotation += marker.linear();
  }
  fit.marker.translation() = position;
  fit.marker.linear() = orthonormal(rotation / static_cast<double>(views.size()));
  return fit;
}

HandEyeFit fit_hand_eye(const RobotModel& model, const std::vector<MarkerView>& views, const HandEyePriors& priors,
                        Carried carried) {
  const HandEyeFit start = closed_form_hand_eye(model, views, carried);
  Problem problem{&model, &views, priors, carried, start.camera, start.marker, {}};
  for (const MarkerView& view : views) problem.weights.push_back(weight_of(view, priors, carried));
  VectorXd x = VectorXd::Zero(problem.inputs());
  minimise(problem, x);
  HandEyeFit fit = problem.at(x);
  Eigen::MatrixXd jacobian(problem.values(), problem.inputs());
  problem.df(x, jacobian);
  const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
  VectorXd residuals(problem.values());
  problem(x, residuals);
  const double variance = std::max(residuals.squaredNorm() / static_cast<double>(residuals.size()), kLeastVariance);
  const Eigen::MatrixXd covariance =
      variance * normal.ldlt().solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
  fit.position_deviation = worst(covariance.block<3, 3>(0, 0));
  fit.rotation_deviation = worst(covariance.block<3, 3>(3, 3));
  fit.focal_deviation = std::sqrt(covariance(12, 12));
  fit.joint_deviation = std::sqrt(covariance.diagonal().segment(14, problem.joints()).maxCoeff());
  fit.marker_position_deviation = worst(covariance.block<3, 3>(6, 6));
  fit.marker_rotation_deviation = worst(covariance.block<3, 3>(9, 9));
  for (const MarkerView& view : views) fit.residuals.push_back(residual_of(model, fit, view));
  return fit;
}

Pose expected_marker(const RobotModel& model, const HandEyeFit& fit, const MarkerView& view) {
  return EstimatedArm(model, fit).marker_at(fit, view);
}

double residual_of(const RobotModel& model, const HandEyeFit& fit, const MarkerView& view) {
  return std::sqrt(Problem::difference(EstimatedArm(model, fit), fit, view).squaredNorm() / 4);
}

}  // namespace mrroc::calibration
