#pragma once

#include <vector>

#include "mrroc/load.hpp"

namespace mrroc::calibration {

/// One reading of a wrist force/torque sensor at rest, without contact.
struct WrenchReading {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< of the sensor frame in the base frame
  Wrench wrench = Wrench::Zero();                          ///< in its axes, about its origin, N and N m
  double time = 0;                                         ///< s, from any start
};

/// The load behind a sensor and the sensor's zero, with the accuracy of both.
struct LoadFit {
  Load load;                      ///< kg; centre in the sensor frame, m
  Wrench zero = Wrench::Zero();   ///< the reading without load at the time of the last reading, N and N m
  Wrench drift = Wrench::Zero();  ///< of the zero, N/s and N m/s
  double mass_deviation = 0;      ///< standard deviation, kg
  double centre_deviation = 0;    ///< of the worst direction, m
  double zero_deviation = 0;      ///< of the worst force of the zero, N
  double spread = 0;              ///< how much the orientations differ, see below
  std::vector<double> force_residuals, torque_residuals;  ///< of each reading: length of what the fit leaves, N, N m
};

/// Identifies load and zero by least squares. With u_k = R_k^T g and the time t_k before the last reading, the model of
/// reading k is
///
///   f_k = m u_k + f_0 - f_d t_k            (unknown: m, f_0, f_d)
///   n_k = h x u_k + n_0 - n_d t_k          (unknown: h = m c, n_0, n_d)
///
/// Both are linear. Deviations are those of the least-squares estimate, with the variance of the residuals. The drift
/// is separable from the weight when the order of the orientations is not that of the time.
///
/// A mass within three deviations of 0 is no load: mass and centre are 0.
///
/// `spread` is sqrt(lambda / n) / |g|, lambda the smallest eigenvalue of sum |d_k|^2 I - d_k d_k^T with d_k = u_k -
/// mean(u): 0.58 for three directions of gravity at right angles to one another.
///
/// `gravity` in the base frame, m/s^2. Throws NonFatalError: not_finite; invalid_argument with fewer than
/// kLeastReadings readings, or a spread below kLeastSpread. Any thread; allocates.
LoadFit fit_load(const std::vector<WrenchReading>& readings, const Eigen::Vector3d& gravity = standard_gravity());

inline constexpr std::size_t kLeastReadings = 6;
inline constexpr double kLeastSpread = 0.1;

}  // namespace mrroc::calibration
