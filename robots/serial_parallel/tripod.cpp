#include "robots/serial_parallel/tripod.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace mrroc::serial_parallel {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kConverged = 1e-12;  // rad or m: Newton's next step would be below rounding

// Sines and cosines of a placement.
struct Turned {
  explicit Turned(const Placement& placement)
      : swing_sine(std::sin(placement.swing)),
        swing_cosine(std::cos(placement.swing)),
        tilt_sine(std::sin(placement.tilt)),
        tilt_cosine(std::cos(placement.tilt)) {}
  double swing_sine, swing_cosine, tilt_sine, tilt_cosine;
};

bool upright(const Placement& placement) {
  return std::abs(placement.swing) < pi / 2 && std::abs(placement.tilt) < pi / 2 && placement.height > 0;
}

// Leg A or C in the plane that swings with it: along the platform's y axis and along its z axis.
struct PlanarLeg {
  PlanarLeg(double base, double platform, double shift, const Placement& placement, const Turned& t)
      : across(platform + shift * t.tilt_sine - base * t.tilt_cosine), along(placement.height + base * t.tilt_sine) {}
  double lean(const Placement& placement) const { return placement.tilt - std::atan2(across, along); }
  double across, along;
};

}  // namespace

Tripod::Tripod(const Geometry& geometry) noexcept
    : base_(geometry.base),
      platform_(geometry.platform),
      platform_to_wrist_(geometry.platform_to_wrist),
      limits_(geometry.limits) {}

Pose Tripod::platform(const Placement& placement) const noexcept {
  const Turned t(placement);
  Pose pose = Pose::Identity();
  pose.linear() << t.swing_cosine, t.swing_sine * t.tilt_sine, t.swing_sine * t.tilt_cosine,  //
      0, t.tilt_cosine, -t.tilt_sine,                                                         //
      -t.swing_sine, t.swing_cosine * t.tilt_sine, t.swing_cosine * t.tilt_cosine;
  pose.translation() = pose.linear() * Vector3d(0, base_.b * t.swing_sine * t.tilt_sine, placement.height);
  return pose;
}

Vector3d Tripod::squared_legs(const Placement& placement, Matrix3d* rates) const noexcept {
  const Turned t(placement);
  const double shift = base_.b * t.swing_sine;
  const double shift_rate = base_.b * t.swing_cosine;
  const PlanarLeg a(base_.a, platform_.a, shift, placement, t), c(base_.c, platform_.c, shift, placement, t);
  const double b_across = platform_.b - shift_rate;
  const double b_along = placement.height - shift * t.tilt_cosine;
  if (rates != nullptr) {
    const auto planar = [&](const PlanarLeg& leg, double base) -> Eigen::RowVector3d {
      return {leg.across * shift_rate * t.tilt_sine,
              leg.across * (shift * t.tilt_cosine + base * t.tilt_sine) + leg.along * base * t.tilt_cosine, leg.along};
    };
    rates->row(0) = planar(a, base_.a);
    rates->row(1) << b_across * shift - b_along * shift_rate * t.tilt_cosine, b_along * shift * t.tilt_sine, b_along;
    rates->row(2) = planar(c, base_.c);
    *rates *= 2;
  }
  return {a.across * a.across + a.along * a.along, Eigen::Vector2d(b_across, b_along).squaredNorm(),
          c.across * c.across + c.along * c.along};
}

Vector3d Tripod::legs(const Placement& placement) const noexcept { return squared_legs(placement).cwiseSqrt(); }

Matrix3d Tripod::leg_rates(const Placement& placement) const noexcept {
  Matrix3d rates;
  const Vector3d squares = squared_legs(placement, &rates);
  return (2 * squares.cwiseSqrt()).cwiseInverse().asDiagonal() * rates;
}

bool Tripod::assemble(const Vector3d& legs, Placement& placement) const noexcept {
  const Vector3d wanted = legs.cwiseAbs2();
  Placement found{.height = legs[0] / 2 + legs[2] / 2};
  placement = {.height = base_.b};
  for (int i = 0; i < kIterations; ++i) {
    Matrix3d rates;
    const Vector3d squares = squared_legs(found, &rates);
    const Vector3d step = rates.inverse() * (wanted - squares);
    found = {found.swing + step[0], found.tilt + step[1], found.height + step[2]};
    if (!(step.cwiseAbs().maxCoeff() < kConverged)) continue;  // also when it is not a number
    if (!upright(found) || (legs.array() <= 0).any()) return false;
    placement = found;
    return true;
  }
  return false;
}

Placement Tripod::placement_of(const Vector3d& centre) const noexcept {
  const double swing = std::atan2(centre.x(), centre.z());
  const double up = std::hypot(centre.x(), centre.z());
  const double tilt = std::atan2(-centre.y(), up - base_.b * std::sin(swing));
  const double height = up * std::cos(tilt) - centre.y() * std::sin(tilt) - platform_to_wrist_;
  return {swing, tilt, height};
}

PassiveAngles Tripod::passive_angles(const Placement& placement) const noexcept {
  const Turned t(placement);
  const double shift = base_.b * t.swing_sine;
  const Vector3d leg_b = platform(placement).linear() *
                         Vector3d(platform_.b - base_.b * t.swing_cosine, 0, placement.height - shift * t.tilt_cosine);
  return {.lean_a = PlanarLeg(base_.a, platform_.a, shift, placement, t).lean(placement),
          .lean_b = std::atan2(-leg_b.y(), std::hypot(leg_b.x(), leg_b.z())),
          .lean_c = PlanarLeg(base_.c, platform_.c, shift, placement, t).lean(placement),
          .pitch_b = std::atan2(leg_b.x(), leg_b.z())};
}

bool Tripod::within_limits(const Placement& placement, double allowance) const noexcept {
  if (!upright(placement)) return false;
  const PassiveAngles angles = passive_angles(placement);
  const double lean_b = std::abs(angles.lean_b) - allowance;
  const double pitch_min = lean_b > limits_.b_lean_inner ? limits_.b_pitch_min_when_lean : limits_.b_pitch_min;
  return std::abs(angles.lean_a) - allowance <= limits_.ac_lean_max &&
         std::abs(angles.lean_c) - allowance <= limits_.ac_lean_max && lean_b <= limits_.b_lean_max &&
         angles.pitch_b + allowance >= pitch_min;
}

}  // namespace mrroc::serial_parallel
