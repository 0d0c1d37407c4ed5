#include "calibration/load_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::calibration {

namespace {

using Matrix3 = Eigen::Matrix3d;

constexpr double kClear = 3;  // standard deviations of a mass from 0

/// A least-squares solution x of A x = b and its covariance.
struct Solution {
  Eigen::VectorXd x;
  Eigen::VectorXd residual;
  Eigen::MatrixXd covariance;
};

Solution solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  Solution solution;
  solution.x = a.colPivHouseholderQr().solve(b);
  solution.residual = b - a * solution.x;
  const auto freedom = static_cast<double>(a.rows() - a.cols());
  const Eigen::MatrixXd normal = a.transpose() * a;
  solution.covariance =
      normal.ldlt().solve(Eigen::MatrixXd::Identity(a.cols(), a.cols())) * (solution.residual.squaredNorm() / freedom);
  return solution;
}

Matrix3 cross_matrix(const Eigen::Vector3d& v) {
  return (Matrix3() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished();
}

double spread_of(const std::vector<Eigen::Vector3d>& gravities) {
  const auto n = static_cast<double>(gravities.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& u : gravities) mean += u / n;
  Matrix3 products = Matrix3::Zero();
  for (const Eigen::Vector3d& u : gravities) products += (u - mean) * (u - mean).transpose();
  const Matrix3 normal = products.trace() * Matrix3::Identity() - products;
  const double weakest = Eigen::SelfAdjointEigenSolver<Matrix3>(normal, Eigen::EigenvaluesOnly).eigenvalues()[0];
  return std::sqrt(std::max(weakest, 0.0) / n) / gravities.front().norm();
}

std::vector<double> lengths(const Eigen::VectorXd& residual) {
  std::vector<double> lengths;
  for (Eigen::Index row = 0; row < residual.size(); row += 3) lengths.push_back(residual.segment<3>(row).norm());
  return lengths;
}

void check(const std::vector<WrenchReading>& readings, const Eigen::Vector3d& gravity) {
  if (!gravity.allFinite() || gravity.isZero(0))
    throw NonFatalError(ErrorCode::invalid_argument, "fit_load: gravity, expected finite and not zero");
  for (const WrenchReading& reading : readings) {
    if (!reading.rotation.allFinite() || !reading.wrench.allFinite() || !std::isfinite(reading.time))
      throw NonFatalError(ErrorCode::not_finite, "a reading for the identification of a load");
  }
  if (readings.size() < kLeastReadings)
    throw NonFatalError(ErrorCode::invalid_argument, "a load from " + std::to_string(readings.size()) +
                                                         " readings, expected at least " +
                                                         std::to_string(kLeastReadings));
}

}  // namespace

LoadFit fit_load(const std::vector<WrenchReading>& readings, const Eigen::Vector3d& gravity) {
  check(readings, gravity);
  LoadFit fit;
  std::vector<Eigen::Vector3d> gravities;
  gravities.reserve(readings.size());
  for (const WrenchReading& reading : readings) gravities.emplace_back(reading.rotation.transpose() * gravity);
  fit.spread = spread_of(gravities);
  if (!(fit.spread >= kLeastSpread))
    throw NonFatalError(ErrorCode::invalid_argument,
                        "the orientations of the readings differ too little to find a "
                        "load: spread " +
                            std::to_string(fit.spread) + ", expected at least " + std::to_string(kLeastSpread));

  const auto rows = static_cast<Eigen::Index>(3 * readings.size());
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(rows, 7), torques = Eigen::MatrixXd::Zero(rows, 9);
  Eigen::VectorXd f(rows), n(rows);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(3 * k);
    const Matrix3 before = (readings[k].time - readings.back().time) * Matrix3::Identity();
    forces.block<3, 1>(row, 0) = gravities[k];
    forces.block<3, 3>(row, 1).setIdentity();
    forces.block<3, 3>(row, 4) = before;
    torques.block<3, 3>(row, 0) = -cross_matrix(gravities[k]);
    torques.block<3, 3>(row, 3).setIdentity();
    torques.block<3, 3>(row, 6) = before;
    f.segment<3>(row) = readings[k].wrench.head<3>();
    n.segment<3>(row) = readings[k].wrench.tail<3>();
  }
  const Solution force = solve(forces, f), torque = solve(torques, n);
  const double mass = force.x[0];
  fit.mass_deviation = std::sqrt(force.covariance(0, 0));
  const bool loaded = mass > kClear * fit.mass_deviation;
  if (loaded) fit.load = {mass, torque.x.head<3>() / mass};
  fit.zero << force.x.segment<3>(1), torque.x.segment<3>(3);
  fit.drift << force.x.segment<3>(4), torque.x.segment<3>(6);
  const Matrix3 moments = torque.covariance.topLeftCorner<3, 3>();
  const double worst = Eigen::SelfAdjointEigenSolver<Matrix3>(moments, Eigen::EigenvaluesOnly).eigenvalues()[2];
  if (loaded)
    fit.centre_deviation =
        std::hypot(std::sqrt(std::max(worst, 0.0)), fit.load.centre.norm() * fit.mass_deviation) / mass;
  fit.zero_deviation = std::sqrt(force.covariance.diagonal().segment<3>(1).maxCoeff());
  fit.force_residuals = lengths(force.residual);
  fit.torque_residuals = lengths(torque.residual);
  return fit;
}

}  // namespace mrroc::calibration
