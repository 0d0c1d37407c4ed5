#pragma once

#include "mrroc/types.hpp"

namespace mrroc {

/// The angular motion of a changing rotation vector: for R = exp([phi]) R0, angular velocity w and its rate, in the
/// axes in which phi is given,
///   w  = J(phi) phi',   w' = J(phi) phi'' + (d/dt J(phi)) phi',
///   J  = I + A [phi] + B [phi]^2,   A = (1 - cos t) / t^2,   B = (t - sin t) / t^3,   t = |phi|,
/// the left Jacobian of SO(3) (Sola, Deray and Atchuthan, A micro Lie theory, 2018, appendix B). Any thread; never
/// allocates or throws.
struct Turning {
  Eigen::Vector3d velocity;
  Eigen::Vector3d rate;
};

/// w and w' from phi, phi', phi''.
Turning turning_of(const Eigen::Vector3d& vector, const Eigen::Vector3d& first, const Eigen::Vector3d& second) noexcept;

/// The inverse: phi' (as `velocity`) and phi'' (as `rate`) from w and w', for |phi| below 2 pi.
Turning vector_rates_of(const Eigen::Vector3d& vector, const Turning& turning) noexcept;

}  // namespace mrroc
