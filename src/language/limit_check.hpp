#pragma once

#include <vector>

#include "core/error_report.hpp"
#include "geometry/quintic.hpp"
#include "language/limit_switches.hpp"
#include "language/stops/common_stop_path.hpp"
#include "language/stops/stop.hpp"
#include "mrroc/robot_model.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc {

/// The limits of a robot, for the path of a macrostep: the EDP accepts it, and a generator plans it, only if this check
/// passes. At every servo tick: position, velocity and acceleration of the joints, position of the motors; the means of
/// velocity, acceleration and jerk from tick to tick. The joints are checked at least eight times per macrostep, so
/// that violations between the ticks of a short one are found, unless bounds of the path show that it cannot. From
/// every tick a stop must be possible: it passes neither position nor velocity limit and rests inside the motor limits;
/// from the last tick the motor limits are checked at every tick of the stop, unless a bound shows that no motor comes
/// near one. The tolerances are those of language/limits.hpp.
///
/// A robot that starts outside a position limit (brakes off, moved by hand) may move, but no farther out; nor may an
/// axis on a limit switch move farther onto it.
///
/// Set-points that are not part of a planned macrostep are checked one by one (`begin`, `check_next`): for each the
/// state itself and the stop from it.
///
/// Allocates nothing but in its constructor, never throws; one thread.
class LimitCheck {
 public:
  LimitCheck(const RobotModel& model, double period);
  /// From now on of this model of the same robot; it must outlive this object.
  void use(const RobotModel& model) noexcept;
  /// The limit switches that are on.
  void stand_on(const LimitSwitches& switches) noexcept { switches_ = switches; }

  /// Class `none`, or the first violation: joint_limit, motor_limit, limit_switch, velocity_limit, acceleration_limit
  /// or jerk_limit, with axis, tick, value and limit; or the reason why a point of the path has no joints. The path
  /// leads from `from` to `to` in `steps` ticks. `at(t, near, state)` gives the state t seconds after the start, `near`
  /// being the joints of the sample before, or the error code. `quintic`: the path, where it is one of the joints; else
  /// null.
  template <class At>
  ErrorReport check(const DesiredState& from, const DesiredState& to, std::uint32_t steps, const Quintic* quintic,
                    At at) noexcept {
    if (const ErrorReport report = check_end(from, to, steps); bad(report)) return report;
    const std::uint32_t fraction = samples_per_tick(from, steps, quintic);
    const std::uint32_t samples = steps * fraction;
    DesiredState previous = from;
    for (std::uint32_t sample = 1; sample <= samples; ++sample) {
      const double tick = static_cast<double>(sample) / fraction;
      DesiredState state = to;
      if (sample < samples)
        if (const ErrorCode code = at(tick * period_, previous.position, state); code != ErrorCode::none)
          return make_report(ErrorClass::non_fatal, code, "on the path, at tick %.4g", tick);
      if (const ErrorReport report = check_between(previous, state, period_ / fraction, tick); bad(report))
        return report;
      previous = state;
      if (sample == samples) break;  // check_end has seen it
      if (const ErrorReport report = check_state(state, tick); bad(report)) return report;
      if (sample % fraction != 0) continue;
      if (const ErrorReport report = check_motors(state.position, tick, "motor position"); bad(report)) return report;
      if (const ErrorReport report = check_stop(state, tick); bad(report)) return report;
    }
    return {};
  }

  /// Checks only the end state, relative to `from`: a longer duration cannot repair its violations.
  ErrorReport check_end(const DesiredState& from, const DesiredState& to, double tick) noexcept {
    widen(from);
    return check_with_stop(to, tick);
  }

  /// Whether `stop`, which begins at the end state that has passed the check last, or at that of `begin`, keeps all
  /// limits; the motors are checked at its end and at every eighth tick.
  bool passes(const CommonStopPath& stop) noexcept;

  /// A motion whose set-points are not known beforehand begins at `from`.
  void begin(const DesiredState& from) noexcept { widen(from); }
  /// Its next set-point. The caller checks the step to it: velocity, acceleration and jerk as means over the tick.
  ErrorReport check_next(const DesiredState& state) noexcept { return check_with_stop(state, 0); }

 private:
  ErrorReport check_with_stop(const DesiredState& state, double tick) noexcept;
  ErrorReport check_state(const DesiredState& state, double tick) const noexcept;
  std::uint32_t samples_per_tick(const DesiredState& from, std::uint32_t steps, const Quintic* quintic) const noexcept;
  /// Between its ends; false: it has to be sampled.
  bool stays_clear(const DesiredState& from, const Quintic& path) const noexcept;
  ErrorReport check_between(const DesiredState& before, const DesiredState& after, double duration,
                            double tick) const noexcept;
  /// Leaves the motor positions of `joints` in `motors_`.
  ErrorReport check_motors(const JointVector& joints, double tick, const char* where) noexcept;
  /// Leaves the stop from `state` in `stop_` and the motor positions of its end in `motors_`.
  ErrorReport check_stop(const DesiredState& state, double tick) noexcept;
  /// Of the stop that `check_stop` has left; false: it must be checked in detail.
  bool motors_stay_clear() const noexcept;
  ErrorReport check_motors_of_stop(double tick) noexcept;
  void widen(const DesiredState& from) noexcept;
  ErrorReport violation(ErrorCode code, int axis, double tick, const char* what, double value,
                        double limit) const noexcept;

  const std::vector<AxisParameters>& axes() const noexcept { return model_->parameters().axes; }

  const RobotModel* model_;
  double period_;
  Stop stop_;
  LimitSwitches switches_;
  JointVector motors_;
  JointVector position_min_, position_max_, motor_min_, motor_max_;
};

}  // namespace mrroc
