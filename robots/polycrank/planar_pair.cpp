#include "robots/polycrank/planar_pair.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::polycrank {
namespace {

using Eigen::Vector2d;

constexpr double kShortest = 1e-10;  // m

Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

Vector2d PlanarPair::joint(double a) const noexcept { return first_ * direction(a); }

Vector2d PlanarPair::end(double a, double b) const noexcept { return joint(a) + second_ * direction(a + b); }

Vector2d PlanarPair::angles(const Vector2d& point, double bend, double free_angle) const noexcept {
  const double cosine = (point.squaredNorm() - first_ * first_ - second_ * second_) / (2 * first_ * second_);
  const double b = bend * std::acos(std::clamp(cosine, -1.0, 1.0));
  if (folds_onto(point)) return {free_angle, b};
  // the end in the frame of the first crank
  const Vector2d seen(first_ + second_ * std::cos(b), second_ * std::sin(b));
  return {std::atan2(point.y(), point.x()) - std::atan2(seen.y(), seen.x()), b};
}

bool PlanarPair::folds_onto(const Vector2d& point) const noexcept {
  return shortest_reach() < kShortest && point.norm() < kShortest;
}

double PlanarPair::longest_reach() const noexcept { return std::abs(first_) + std::abs(second_); }

double PlanarPair::shortest_reach() const noexcept { return std::abs(std::abs(first_) - std::abs(second_)); }

}  // namespace mrroc::polycrank
