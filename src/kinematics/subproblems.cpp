#include "kinematics/subproblems.hpp"

#include <cmath>

namespace mrroc::kinematics {

namespace {

constexpr double kFree = 1e-9;   // sine of the angle between a vector and the axis about which it turns
constexpr double kExact = 1e-7;  // of lengths, relative to those of the vectors

/// R(k, a) p = k (k . p) + A (sin a, cos a).
Eigen::Matrix<double, 3, 2> circle(const Eigen::Vector3d& k, const Eigen::Vector3d& p) noexcept {
  Eigen::Matrix<double, 3, 2> a;
  a.col(0) = k.cross(p);
  a.col(1) = -k.cross(a.col(0));
  return a;
}

}  // namespace

Angles rotate_onto(const Eigen::Vector3d& k, const Eigen::Vector3d& p, const Eigen::Vector3d& q) noexcept {
  const Eigen::Vector2d x = circle(k, p).transpose() * q;
  const double scale = 1 + p.norm() + q.norm();
  const bool exact = std::abs(p.norm() - q.norm()) < kExact * scale && std::abs(k.dot(p - q)) < kExact * scale;
  return {{std::atan2(x[0], x[1]), 0}, 1, exact, x.norm() < kFree * p.norm() * q.norm()};
}

AnglePairs rotate_both(const Eigen::Vector3d& k1, const Eigen::Vector3d& p, const Eigen::Vector3d& k2,
                       const Eigen::Vector3d& q) noexcept {
  const double scale = 1 + p.norm() + q.norm();
  const bool same_length = std::abs(p.norm() - q.norm()) < kExact * scale;
  const Eigen::Vector3d p1 = p.normalized(), p2 = q.normalized();
  const Eigen::Matrix<double, 3, 2> a1 = circle(k1, p1), a2 = circle(k2, p2);
  AnglePairs pairs;
  const double radius1 = a1.col(0).squaredNorm(), radius2 = a2.col(0).squaredNorm();
  pairs.free = radius1 < kFree || radius2 < kFree;
  if (pairs.free) return pairs;
  const double k1p1 = k1.dot(p1), k2p2 = k2.dot(p2), k1k2 = k1.dot(k2);
  const double fraction = 1 / (1 - k1k2 * k1k2);
  const double alpha1 = fraction * (k1p1 - k1k2 * k2p2), alpha2 = fraction * (k2p2 - k1k2 * k1p1);
  const Eigen::Vector2d x1 = alpha2 * (a1.transpose() * k2) / radius1, x2 = alpha1 * (a2.transpose() * k1) / radius2;
  const Eigen::Vector3d normal = k1.cross(k2);
  const Eigen::Vector2d n1 = a1.transpose() * normal / radius1, n2 = a2.transpose() * normal / radius2;
  const double rest = 1 - x1.squaredNorm();
  pairs.exact = same_length && rest > -kExact;
  if (rest <= 0) {
    pairs.count = 1;
    pairs.value[0] = std::atan2(x1[0], x1[1]);
    pairs.other[0] = std::atan2(x2[0], x2[1]);
    return pairs;
  }
  const double xi = std::sqrt(rest) / n1.norm();
  pairs.count = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    const double sign = i == 0 ? xi : -xi;
    const Eigen::Vector2d s1 = x1 + sign * n1, s2 = x2 + sign * n2;
    pairs.value[i] = std::atan2(s1[0], s1[1]);
    pairs.other[i] = std::atan2(s2[0], s2[1]);
  }
  return pairs;
}

Angles rotate_to_distance(const Eigen::Vector3d& k, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                          double d) noexcept {
  return rotate_to_plane(q, k, p, 0.5 * (p.squaredNorm() + q.squaredNorm() - d * d));
}

Angles rotate_to_plane(const Eigen::Vector3d& h, const Eigen::Vector3d& k, const Eigen::Vector3d& p,
                       double d) noexcept {
  const Eigen::Vector2d a = circle(k, p).transpose() * h;
  const double b = d - h.dot(k) * k.dot(p);
  const double square = a.squaredNorm();
  const Eigen::Vector2d least = a * b;
  Angles angles;
  if (square < kFree * kFree * h.squaredNorm() * p.squaredNorm()) {
    angles.count = 1;
    angles.free = true;
    angles.exact = std::abs(b) < kExact * (1 + std::abs(d));
    return angles;
  }
  const double rest = square - b * b;
  const double scale = kExact * (1 + square);
  if (rest <= 0) {
    angles = {{std::atan2(least[0], least[1]), 0}, 1, rest > -scale};
    return angles;
  }
  const double xi = std::sqrt(rest);
  const Eigen::Vector2d across(a[1], -a[0]);
  angles.count = 2;
  angles.exact = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector2d s = least + (i == 0 ? xi : -xi) * across;
    angles.value[i] = std::atan2(s[0], s[1]);
  }
  return angles;
}

}  // namespace mrroc::kinematics
