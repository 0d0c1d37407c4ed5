#pragma once

#include <functional>

#include "language/limit_check.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// A motion that is refused is planned again in a whole number of macrosteps, because a last macrostep that is longer
/// than the rest of the motion overshoots its end, and then slower: stops on the way, each axis by itself, stay nearer
/// to the path. So many times as long, at least:
inline constexpr double kSlower[] = {1, 1.02, 1.1, 1.25, 1.5, 2.25, 3.4};

/// Whether the EDP would accept a motion that is planned but has not begun: the macrosteps that it consists of are
/// checked by the EDP's own LimitCheck, as polynomials of degree five between the planned states at their ends. Where
/// no macrostep of an interval can come near a position or motor limit, stops included, the interval is passed over:
/// with |v| <= min(v_max, max(|v0|, |v1|) + A T / 2) in an interval of duration T, a joint moves at most |v| T / 2 from
/// its middle, and a stop at most v^2 / 2 A + v A / J + A^3 / J^2. So a motion far from all limits costs a few checks,
/// one of hours no more than a short one.
///
/// Task's thread; allocates nothing but in the constructor.
class MotionCheck {
 public:
  /// The planned desired state `time` s after the start.
  using States = std::function<DesiredState(double time)>;

  explicit MotionCheck(const Robot& robot);

  /// Class `none`, or the first report of LimitCheck. The motion goes through `states` from 0 to `duration` s in
  /// macrosteps of the robot; the last one ends at rest in the state of `duration`. `start`: the macrostep that is
  /// reported, from 0. `cruise`: the part of the velocity limits above which no axis speeds up, 0..1; a slow motion is
  /// checked in the time of a fast one.
  ErrorReport check(const States& states, double duration, double& start, double cruise = 1);

  /// The same. Throws NonFatalError with the report's code and text, and the time.
  void require(const States& states, double duration, double cruise = 1);

 private:
  ErrorReport check_interval(std::int64_t first, std::int64_t last, const DesiredState& from, const DesiredState& to);
  ErrorReport check_macrostep(const DesiredState& from, const DesiredState& to);
  bool is_clear(std::int64_t first, std::int64_t last, const DesiredState& from, const DesiredState& to) const;
  DesiredState state(std::int64_t macrostep) const;

  const Robot* robot_;
  const RobotModel* model_;
  LimitCheck limits_;
  const States* states_ = nullptr;
  double step_ = 0, duration_ = 0, cruise_ = 1;
  std::int64_t macrosteps_ = 0, reported_ = 0;
};

}  // namespace mrroc
