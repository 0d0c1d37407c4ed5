#pragma once

#include <Eigen/Core>
#include <vector>

namespace mrroc {

enum class SplineOrder {
  cubic,   ///< continuous second derivative: the least mean square of it
  quintic  ///< continuous fourth derivative: the least mean square of the third
};

enum class SplineEnds {
  straight,  ///< no curvature at the ends: second (and, quintic, third) derivative 0
  at_rest    ///< first and second derivative 0; a cubic's pieces at the ends are of degree five
};

/// Derivatives of the spline through the knots, at the knots; one row each. QuinticPieces between them are the spline.
struct KnotRates {
  Eigen::MatrixXd first, second;
};

/// `knots`: at least 2, ascending. `values`: one row per knot. Task's thread; allocates.
KnotRates knot_rates(SplineOrder order, SplineEnds ends, const std::vector<double>& knots,
                     const Eigen::MatrixXd& values);

}  // namespace mrroc
