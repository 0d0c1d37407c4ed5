#pragma once

#include "geometry/desired_state.hpp"

namespace mrroc {

/// The path inside a macrostep: for every joint the polynomial of degree five that leads from (p0, v0, a0) to
/// (p1, v1, a1) in the time D. With s = t / D,
///   p(s) = p0 + v0 D s + a0 D^2/2 s^2 + c3 s^3 + c4 s^4 + c5 s^5,
/// where c3..c5 follow from the end state. Allocates nothing, never throws.
class Quintic {
 public:
  void plan(const DesiredState& from, const DesiredState& to, double duration) noexcept {
    duration_ = duration;
    c0_ = from.position;
    c1_ = from.velocity * duration;
    c2_ = from.acceleration * (0.5 * duration * duration);
    // the difference of the end state from the continuation of the start state
    const JointVector p = to.position - c0_ - c1_ - c2_;
    const JointVector v = to.velocity * duration - c1_ - 2.0 * c2_;
    const JointVector a = to.acceleration * (duration * duration) - 2.0 * c2_;
    c3_ = 10.0 * p - 4.0 * v + 0.5 * a;
    c4_ = -15.0 * p + 7.0 * v - a;
    c5_ = 6.0 * p - 3.0 * v + 0.5 * a;
  }

  /// State at the time t of 0..D after the start, s.
  DesiredState at(double t) const noexcept {
    const double s = t / duration_;
    DesiredState state;
    state.position = c0_ + s * (c1_ + s * (c2_ + s * (c3_ + s * (c4_ + s * c5_))));
    state.velocity = (c1_ + s * (2.0 * c2_ + s * (3.0 * c3_ + s * (4.0 * c4_ + s * 5.0 * c5_)))) / duration_;
    state.acceleration = (2.0 * c2_ + s * (6.0 * c3_ + s * (12.0 * c4_ + s * 20.0 * c5_))) / (duration_ * duration_);
    return state;
  }

  /// The largest |p - p0|, |v|, |a| and |jerk| that are possible, per joint.
  struct Bounds {
    JointVector position, velocity, acceleration, jerk;
  };
  /// Bounds over the whole path: the sums of the magnitudes of the terms. Tight for a short piece of a smooth motion.
  Bounds bounds() const noexcept {
    const auto sum = [this](double k1, double k2, double k3, double k4, double k5) {
      return JointVector(k1 * c1_.cwiseAbs() + k2 * c2_.cwiseAbs() + k3 * c3_.cwiseAbs() + k4 * c4_.cwiseAbs() +
                         k5 * c5_.cwiseAbs());
    };
    return {sum(1, 1, 1, 1, 1), sum(1, 2, 3, 4, 5) / duration_, sum(0, 2, 6, 12, 20) / (duration_ * duration_),
            sum(0, 0, 6, 24, 60) / (duration_ * duration_ * duration_)};
  }

 private:
  double duration_ = 1;
  JointVector c0_, c1_, c2_, c3_, c4_, c5_;
};

}  // namespace mrroc
