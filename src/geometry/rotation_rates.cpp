#include "geometry/rotation_rates.hpp"

#include <Eigen/LU>
#include <cmath>

namespace mrroc {

namespace {

/// A, B, and their derivatives by the angle over the angle: series where the fractions lose their digits.
struct Coefficients {
  explicit Coefficients(double angle) noexcept {
    const double square = angle * angle;
    if (angle < 0.1) {
      a = 1.0 / 2 - square * (1.0 / 24 - square * (1.0 / 720 - square / 40320));
      b = 1.0 / 6 - square * (1.0 / 120 - square * (1.0 / 5040 - square / 362880));
      a_slope = -1.0 / 12 + square * (1.0 / 180 - square * (1.0 / 6720 - square / 453600));
      b_slope = -1.0 / 60 + square * (1.0 / 1260 - square * (1.0 / 60480 - square / 4989600));
      return;
    }
    a = (1 - std::cos(angle)) / square;
    b = (angle - std::sin(angle)) / (square * angle);
    a_slope = (std::sin(angle) / angle - 2 * a) / square;
    b_slope = (a - 3 * b) / square;
  }
  double a, b, a_slope, b_slope;
};

/// J(phi) x.
Eigen::Vector3d mapped(const Coefficients& c, const Eigen::Vector3d& vector, const Eigen::Vector3d& x) noexcept {
  const Eigen::Vector3d once = vector.cross(x);
  return x + c.a * once + c.b * vector.cross(once);
}

/// (dJ/dt) phi'.
Eigen::Vector3d drift(const Coefficients& c, const Eigen::Vector3d& vector, const Eigen::Vector3d& first) noexcept {
  const Eigen::Vector3d once = vector.cross(first);
  const double growth = vector.dot(first);
  return growth * (c.a_slope * once + c.b_slope * vector.cross(once)) + c.b * first.cross(once);
}

}  // namespace

Turning turning_of(const Eigen::Vector3d& vector, const Eigen::Vector3d& first,
                   const Eigen::Vector3d& second) noexcept {
  const Coefficients c(vector.norm());
  return {mapped(c, vector, first), mapped(c, vector, second) + drift(c, vector, first)};
}

Turning vector_rates_of(const Eigen::Vector3d& vector, const Turning& turning) noexcept {
  const Coefficients c(vector.norm());
  Eigen::Matrix3d jacobian;
  for (int i = 0; i < 3; ++i) jacobian.col(i) = mapped(c, vector, Eigen::Vector3d::Unit(i));
  const Eigen::Matrix3d inverse = jacobian.inverse();
  const Eigen::Vector3d first = inverse * turning.velocity;
  return {first, inverse * (turning.rate - drift(c, vector, first))};
}

}  // namespace mrroc
