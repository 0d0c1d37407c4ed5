#pragma once

#include <functional>

#include "language/limit_check.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// A refused motion is planned again in a whole number of macrosteps, because a last macrostep that is longer than the
/// rest of the motion overshoots its end. Then it is planned slower: stops of each axis on its own then stay closer to
/// the path. Minimum factors of the duration:
inline constexpr double kSlower[] = {1, 1.02, 1.1, 1.25, 1.5, 2.25, 3.4, 5.1, 7.7, 11.5, 17};

/// Pace of a motion: from `from` s on, no joint exceeds `speed` times its velocity limit or speed^2 times its
/// acceleration limit.
struct MotionPace {
  double from = 0;
  double speed = 1;
};

/// Whether the EDP would accept a motion that is planned but has not begun: the macrosteps that it consists of are
/// checked by the EDP's own LimitCheck, as polynomials of degree five between the planned states at their ends.
///
/// An interval is skipped if no macrostep of it can come near a position or motor limit, stops included. With the
/// limits V, A, J of a joint and its pace p, an interval of T s from q0, v0 to q1, v1 holds |v| <= v = min(p V,
/// max(|v0|, |v1|) + p^2 A T / 2), stays within min(v T / 2, |q1 - q0| / 2 + p^2 A T^2 / 8) of (q0 + q1) / 2, and a
/// stop from it takes at most u p^2 A / J + u / 2 (u / A + min(A / J, 2 sqrt(u / J))) more, with u = v + p^4 A^2 / 2 J.
/// So a motion far from all limits costs a few checks, independent of its duration.
///
/// Task's thread; allocates nothing but in the constructor.
class MotionCheck {
 public:
  /// The planned desired state `time` s after the start.
  using States = std::function<DesiredState(double time)>;

  explicit MotionCheck(const Robot& robot);

  /// Class `none`, or the first report of LimitCheck. The motion goes through `states` from 0 to `duration` s in
  /// macrosteps of the robot; the last one ends at rest in the state of `duration`. `start`: the macrostep that is
  /// reported, from 0. A robot that is not synchronised has no joints yet: its EDP refuses the motion, with that
  /// reason.
  ErrorReport check(const States& states, double duration, double& start, MotionPace pace = {});

  /// The same. Throws NonFatalError with the report's code and text, and the time.
  void require(const States& states, double duration, MotionPace pace = {});

 private:
  ErrorReport check_interval(std::int64_t first, std::int64_t last, const DesiredState& from, const DesiredState& to);
  ErrorReport check_macrostep(const DesiredState& from, const DesiredState& to);
  bool is_clear(std::int64_t first, std::int64_t last, const DesiredState& from, const DesiredState& to) const;
  DesiredState state(std::int64_t macrostep) const;

  const Robot* robot_;
  const RobotModel* model_;
  LimitCheck limits_;
  const States* states_ = nullptr;
  double step_ = 0, duration_ = 0;
  MotionPace pace_;
  std::int64_t macrosteps_ = 0, reported_ = 0;
};

}  // namespace mrroc
