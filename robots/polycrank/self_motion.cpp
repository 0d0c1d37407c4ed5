#include "robots/polycrank/self_motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace mrroc::polycrank {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSteps = 40;
constexpr double kLongestStep = 0.5;   // rad
constexpr double kAtRest = 1e-11;      // rad along the curve
constexpr double kNoDirection = 1e-9;  // m^3: both pairs stretched or folded
constexpr int kCorrections = 8;
constexpr double kOnTheCurve = 1e-14;   // m, where a correction ends
constexpr double kOffTheCurve = 1e-13;  // m, where it has failed

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// The two crank vectors of a pair.
struct CrankVectors {
  CrankVectors(const PlanarPair& pair, double a, double b) : first(pair.joint(a)), second(pair.end(a, b) - first) {}
  Vector2d first, second;
};

}  // namespace

SelfMotion::SelfMotion(const PlanarPair& shoulder, const PlanarPair& elbow, const Cranks& posture) noexcept
    : shoulder_(shoulder), elbow_(elbow), posture_(posture) {
  const double f = posture[0] + posture[1] + posture[2];
  radial_ << std::cos(f), std::sin(f);
  reach_ = reach(posture);
}

Cranks SelfMotion::nearest(const Cranks& near) const noexcept {
  Cranks q = start(near);
  double longest = kLongestStep, last_step = 0, last_distance = 0;
  for (int i = 0; i < kSteps; ++i) {
    const Cranks curve = direction(q);
    const double norm = curve.norm();
    if (!(norm > kNoDirection)) break;
    // to the point where the curve is at right angles to `near`: the secant's zero, or ahead while it bends away
    const double distance = curve.dot(near - q) / norm;
    if (std::abs(distance) < kAtRest) break;
    const double slope = (last_distance - distance) * last_step;
    const double step = distance * (slope > 0 ? last_step * last_step / slope : 1);
    last_step = std::clamp(step, -longest, longest);
    last_distance = distance;
    Cranks next = q + curve * (last_step / norm);
    if (come_back(next)) {
      q = next;
    } else {
      longest = std::abs(last_step) / 4;
      last_step = 0;
    }
  }
  return q;
}

Cranks SelfMotion::start(const Cranks& near) const noexcept {
  Cranks straight = near;
  straight.head<3>().array() += (posture_ - near).head<3>().mean();
  straight.tail<3>().array() += (posture_ - near).tail<3>().mean();
  const bool better = come_back(straight) && (straight - near).squaredNorm() < (posture_ - near).squaredNorm();
  return better ? straight : posture_;
}

Cranks SelfMotion::direction(const Cranks& q) const noexcept {
  const CrankVectors shoulder(shoulder_, q[0], q[1]), elbow(elbow_, q[3], q[4]);
  const double v = cross(shoulder.first, shoulder.second), w = cross(elbow.first, elbow.second);
  const double j = shoulder.first.dot(radial_), k = shoulder.second.dot(radial_);
  const double i = elbow.first.x(), m = elbow.second.x();
  Cranks direction;
  direction << -w * k, w * (j + k), -w * j, v * m, -v * (i + m), v * i;
  return direction;
}

// Newton's method with the least change that keeps both sums.
bool SelfMotion::come_back(Cranks& q) const noexcept {
  for (int i = 0; i < kCorrections; ++i) {
    const Vector3d error = reach_ - reach(q);
    if (error.norm() < kOnTheCurve) return true;
    const Vector2d shoulder = shoulder_.end(q[0], q[1]), elbow = elbow_.end(q[3], q[4]);
    const Vector2d k = shoulder - shoulder_.joint(q[0]), m = elbow - elbow_.joint(q[3]);
    const auto about_x = [](const Vector2d& v) { return Vector3d(0, -v.y(), v.x()); };
    const auto about_side = [&](const Vector2d& v) {
      return Vector3d(v.x(), -v.y() * radial_.x(), -v.y() * radial_.y());
    };
    Eigen::Matrix<double, 3, 6> slope;
    slope << about_x(shoulder), about_x(k), Vector3d::Zero(), about_side(elbow), about_side(m), Vector3d::Zero();
    // the rest of a change of one joint after the other two of its sum compensate it
    slope.leftCols<3>().colwise() -= Vector3d(slope.leftCols<3>().rowwise().mean());
    slope.rightCols<3>().colwise() -= Vector3d(slope.rightCols<3>().rowwise().mean());
    q += slope.transpose() * ((slope * slope.transpose()).inverse() * error);
  }
  return (reach_ - reach(q)).norm() < kOffTheCurve;
}

Vector3d SelfMotion::reach(const Cranks& q) const noexcept {
  const Vector2d shoulder = shoulder_.end(q[0], q[1]), elbow = elbow_.end(q[3], q[4]);
  return {elbow.y(), shoulder.x() + elbow.x() * radial_.x(), shoulder.y() + elbow.x() * radial_.y()};
}

}  // namespace mrroc::polycrank
