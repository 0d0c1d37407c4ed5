#include "mrroc/load_identification.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <string>

#include "language/limits.hpp"
#include "mrroc/errors.hpp"

namespace mrroc {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kClear = 3;  // standard deviations from 0 of a significant mass

}  // namespace

LoadIdentification::LoadIdentification(Offset offset, const Eigen::Vector3d& gravity)
    : offset_(offset), gravity_(gravity) {
  if (!gravity.allFinite() || gravity.isZero(0))
    throw NonFatalError(ErrorCode::invalid_argument, "LoadIdentification: gravity, expected finite and not zero");
}

void LoadIdentification::add(const Eigen::Matrix3d& rotation, const Wrench& wrench) {
  if (!rotation.allFinite() || !wrench.allFinite())
    throw NonFatalError(ErrorCode::not_finite, "a reading for the identification of a load");
  readings_.push_back({rotation.transpose() * gravity_, wrench});
}

LoadEstimate LoadIdentification::estimate() const {
  const bool fitted = offset_ == Offset::unknown;
  const std::size_t least = fitted ? 3 : 2;
  if (readings_.size() < least) {
    throw NonFatalError(ErrorCode::invalid_argument, "a load from " + std::to_string(readings_.size()) +
                                                         " orientations, expected at least " + std::to_string(least));
  }
  const auto n = static_cast<double>(readings_.size());
  Eigen::Vector3d mean_gravity = Eigen::Vector3d::Zero();
  Wrench mean_wrench = Wrench::Zero();
  if (fitted) {
    for (const Reading& reading : readings_) {
      mean_gravity += reading.gravity / n;
      mean_wrench += reading.wrench / n;
    }
  }

  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();  // sum d d^T
  double work = 0;                                     // sum d . f
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();   // sum d x t
  for (const Reading& reading : readings_) {
    const Eigen::Vector3d d = reading.gravity - mean_gravity;
    const Wrench wrench = reading.wrench - mean_wrench;
    products += d * d.transpose();
    work += d.dot(wrench.head<3>());
    turning += d.cross(wrench.tail<3>());
  }
  const double square = products.trace();  // sum d . d
  const Eigen::Matrix3d normal = square * Eigen::Matrix3d::Identity() - products;
  const double weakest =
      std::max(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal, Eigen::EigenvaluesOnly).eigenvalues()[0], 0.0);
  LoadEstimate result;
  result.spread = std::sqrt(weakest / n) / gravity_.norm();
  if (!(result.spread >= kLeastSpread)) {
    throw NonFatalError(ErrorCode::invalid_argument, "the orientations of " + std::to_string(readings_.size()) +
                                                         " readings differ too little to find a load: spread " +
                                                         number_text(result.spread, kLeastSpread) +
                                                         ", expected at least " +
                                                         number_text(kLeastSpread, result.spread));
  }

  Load& load = result.load;
  load.mass = work / square;
  load.centre = normal.ldlt().solve(turning) / load.mass;
  result.offset << mean_wrench.head<3>() - load.mass * mean_gravity,
      mean_wrench.tail<3>() - load.centre.cross(load.mass * mean_gravity);
  double forces = 0, torques = 0;  // squares of the residuals
  for (const Reading& reading : readings_) {
    const Eigen::Vector3d weight = load.mass * reading.gravity;
    forces += (reading.wrench.head<3>() - weight - result.offset.head<3>()).squaredNorm();
    torques += (reading.wrench.tail<3>() - load.centre.cross(weight) - result.offset.tail<3>()).squaredNorm();
  }
  result.force_residual = std::sqrt(forces / (3 * n));
  result.torque_residual = std::sqrt(torques / (3 * n));
  const double force_freedom = 3 * n - (fitted ? 4 : 1), torque_freedom = 3 * n - (fitted ? 6 : 3);
  result.mass_deviation = std::sqrt(forces / force_freedom / square);
  result.centre_deviation = std::hypot(std::sqrt(torques / torque_freedom / weakest) / load.mass,
                                       load.centre.norm() * result.mass_deviation / load.mass);
  if (!(load.mass > kClear * result.mass_deviation)) {
    load.centre.setConstant(kNan);
    result.centre_deviation = std::numeric_limits<double>::infinity();
  }
  return result;
}

}  // namespace mrroc
