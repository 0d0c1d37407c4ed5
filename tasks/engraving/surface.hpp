#pragma once

#include <Eigen/Core>
#include <vector>

#include "mrroc/types.hpp"

namespace engraving {

/// The points of a grid over `size` (m), its middle at the origin: column by column, to and fro. `columns` go along x,
/// `rows` along y; a single one is in the middle. Throws NonFatalError(invalid_argument) unless both are at least 1.
std::vector<Eigen::Vector2d> grid(const Eigen::Vector2d& size, int columns, int rows);

/// A surface z = h(x, y) through points probed with a ball. With s and t the coordinates scaled to -1..1 over the
/// box of the points, and Chebyshev polynomials T,
///
///   h(x, y) = sum c_ij T_i(s) T_j(t),   i of 0..a, j of 0..b,
///
/// with the c of least squares. A grid of n points along x has a = min(n - 1, 2 n / 3), so that noise is evened out and
/// the fit does not oscillate between the points; b is defined in the same way. A ball touches a slope not below its
/// centre: its centre p is at the radius r along the normal n from the point, so the fit is of p - r n, with the
/// normals of the fit before (four rounds; each leaves some r times the curvature of the error before).
class Surface {
 public:
  /// `centres` of the touching ball and its `radius`, m, at `along_x` x `along_y` points. Throws
  /// NonFatalError(invalid_argument): the points do not determine the polynomial.
  Surface(const std::vector<Eigen::Vector3d>& centres, double radius, int along_x, int along_y);

  double height(double x, double y) const;           ///< m
  Eigen::Vector3d normal(double x, double y) const;  ///< of length 1, up
  /// A tool at right angles to the surface at `xy`, its tip `depth` (m) inside: z against the normal, x level with
  /// the frame's.
  mrroc::Pose tool_at(const Eigen::Vector2d& xy, double depth) const;
  /// Distance of the points from the surface along z, m RMS.
  double residual() const noexcept { return rms_; }

 private:
  /// T_0..T_degree at `s`, and their derivatives.
  static Eigen::VectorXd values(double s, int degree);
  static Eigen::VectorXd slopes(double s, int degree);
  void fit(const std::vector<Eigen::Vector3d>& points);
  Eigen::Vector2d scaled(double x, double y) const { return (Eigen::Vector2d(x, y) - middle_).cwiseQuotient(half_); }

  int degree_x_, degree_y_;
  Eigen::Vector2d middle_, half_;  ///< of the points' box, m
  Eigen::MatrixXd coefficients_;   ///< c
  double rms_ = 0;
};

}  // namespace engraving
