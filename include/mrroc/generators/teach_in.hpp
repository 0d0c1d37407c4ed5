#pragma once

#include <cstddef>
#include <optional>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/taught_path.hpp"

namespace mrroc {

/// Records the motion of a robot. It commands nothing itself: alone it lets the robot hold; with another generator it
/// records that motion:
///
///   Move({arm}, {}, Together{LeadThrough{arm}, TeachIn{arm, path, 0.1}}.until(OperatorTrigger{*this}));
///
/// It records the desired state, joints and pose, so a replay repeats the commands. Continuously: it starts a new timed
/// path with a point every `interval` s (rounded up to whole steps); its time excludes pauses. At the operator's
/// triggers: it adds one point per trigger to the path; do not use `OperatorTrigger` in such a Move, because a trigger
/// is consumed once.
///
/// Continues until a condition of `.until(...)` holds. (The original's `teach_in`.)
class TeachIn : public Generator {
 public:
  /// Enough points for hours at 10 / s.
  static constexpr std::size_t kMost = 100000;

  /// Continuously. `path` must outlive the Move; memory is reserved for `most` points. Throws
  /// NonFatalError(invalid_argument) unless `interval` is finite and above 0.
  TeachIn(Robot& robot, TaughtPath& path, double interval, std::size_t most = kMost);
  /// At triggers.
  TeachIn(Robot& robot, TaughtPath& path);

  void start() override;
  void resume() override;
  /// Records; returns false. Throws NonFatalError(resources) when the path is full.
  bool terminal_condition() override;
  void next_state() override {}

 private:
  void note(double time);

  Robot* robot_;
  TaughtPath* path_;
  std::optional<double> interval_;
  std::size_t most_;
  double time_ = 0;  // s since the start
  double next_ = 0;  // time of the next point
  Tick last_ = 0;    // of time_
};

}  // namespace mrroc
