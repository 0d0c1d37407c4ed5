#pragma once

#include "edp/check/model_set.hpp"
#include "edp/command/effector.hpp"
#include "edp/command/planner.hpp"
#include "mrroc/robot_command.hpp"

namespace mrroc::edp {

/// A motion of the operator from rest to rest, to a goal: `joint`, `motor` or `pose`, absolute or relative. A relative
/// `pose` with a `twist` is a displacement in base axes: p + v, exp(w) R. The whole path is planned and checked before
/// it begins; its duration follows from the limits. It is commanded in pieces, so that it can end at any time. One
/// thread, the effector's; only the constructor allocates, nothing throws.
class OperatorTravel {
 public:
  static constexpr std::uint16_t kSteps = 10;  ///< ticks of a piece

  /// `models` outlives it. `period` in s.
  OperatorTravel(const ModelSet& models, double period);

  /// Plans the path of `order` from where `effector` rests. An error: a robot that moves or has not ticked yet (busy),
  /// a goal that is out of reach or beyond a limit.
  ErrorReport plan(const RobotCommand& order, Effector& effector) noexcept;
  /// Whether the whole path has been commanded.
  bool over() const noexcept { return travelled_ == duration_; }
  /// Writes the next piece; `commanded` when the effector has taken it.
  ErrorReport write(RobotCommand& piece) noexcept;
  void commanded() noexcept;

 private:
  const ModelSet& models_;
  const double period_;
  Planner planner_;
  Macrostep path_;                              // the whole path; too large for a small stack
  double slowness_ = 1;                         // by how much it is slower than planned
  std::uint32_t travelled_ = 0, duration_ = 0;  // ticks
  std::uint32_t piece_end_ = 0;                 // of the piece that was written last
  DesiredState goal_;                           // there
};

}  // namespace mrroc::edp
