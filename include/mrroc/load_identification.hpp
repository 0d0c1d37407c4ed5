#pragma once

#include <vector>

#include "mrroc/load.hpp"

namespace mrroc {

/// A measured load and its accuracy.
struct LoadEstimate {
  Load load;                       ///< centre: NaN if the mass cannot be distinguished from 0
  Wrench offset = Wrench::Zero();  ///< the sensor's reading without it, N and N m
  double mass_deviation = 0;       ///< standard deviation, kg
  double centre_deviation = 0;     ///< of the worst direction, m
  double force_residual = 0;       ///< root mean square residual of the fit, N
  double torque_residual = 0;      ///< the same for the torque, N m
  double spread = 0;               ///< how much the orientations differ, see below
};

/// Identifies a load from the wrenches that a sensor measures in several orientations at rest. Reading k is taken in a
/// frame rotated by R_k in the base frame; with u_k = R_k^T g the model is
///
///   f_k = m u_k + f_0            t_k = c x (m u_k) + t_0
///
/// solved by least squares, the force first. With d_k = u_k - mean(u) (with a known offset d_k = u_k):
///
///   m = sum d_k . f_k / sum d_k . d_k
///   (sum |d_k|^2 I - d_k d_k^T) c = (1 / m) sum d_k x t_k
///
/// The offset (f_0, t_0) is the part of the readings that the sensor's zero, possibly taken in another posture, adds.
/// With an unknown offset the zero does not matter, but the readings need at least three different directions of
/// gravity in the frame; with a known offset, two. `spread` is sqrt(lambda / n) / |g|, where lambda is the smallest
/// eigenvalue of the matrix above: 0.58 for three directions at right angles to one another, 0.15 for three on a cone
/// of 15 degrees.
/// Task's thread.
class LoadIdentification {
 public:
  enum class Offset { unknown, zero };

  /// `gravity` in the base frame, m/s^2. Throws NonFatalError(invalid_argument) unless it is finite and not zero.
  explicit LoadIdentification(Offset offset = Offset::unknown, const Eigen::Vector3d& gravity = standard_gravity());

  /// Memory for `count` readings, so that `add` does not allocate.
  void reserve(std::size_t count) { readings_.reserve(count); }
  void clear() noexcept { readings_.clear(); }
  std::size_t size() const noexcept { return readings_.size(); }
  /// One reading: the wrench in the axes and about the origin of a frame that is rotated by `rotation` in the base
  /// frame. Throws NonFatalError(not_finite).
  void add(const Eigen::Matrix3d& rotation, const Wrench& wrench);

  /// Throws NonFatalError(invalid_argument) when the orientations are too few or differ too little: a spread below
  /// kLeastSpread.
  LoadEstimate estimate() const;

  static constexpr double kLeastSpread = 0.1;

 private:
  struct Reading {
    Eigen::Vector3d gravity;  ///< u_k
    Wrench wrench;
  };

  Offset offset_;
  Eigen::Vector3d gravity_;
  std::vector<Reading> readings_;
};

}  // namespace mrroc
