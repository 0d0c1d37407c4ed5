#pragma once

#include <cstddef>
#include <optional>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/taught_path.hpp"

namespace mrroc {

/// Writes down where a robot goes. It commands nothing itself: alone it lets the robot hold, beside another generator
/// it goes along, as the hand of a person who teaches and the pencil of one who notes:
///
///   Move({arm}, {}, Together{LeadThrough{arm}, TeachIn{arm, path, 0.1}}.until(OperatorTrigger{*this}));
///
/// The desired state is what is noted, joints and pose, so a replay commands what was commanded. Continuously: a timed
/// path, which it begins again, a point every `interval` s (rounded up to whole steps); pauses are not part of its
/// time. At the operator's triggers: a point for each, added to the path; leave `OperatorTrigger` out of such a Move, a
/// trigger is taken once.
///
/// Keeps on until a condition of `.until(...)` holds. (The original's `teach_in`.)
class TeachIn : public Generator {
 public:
  /// Points enough for hours at 10 / s.
  static constexpr std::size_t kMost = 100000;

  /// Continuously. `path` must outlive the Move; it has memory for `most` points. Throws
  /// NonFatalError(invalid_argument) unless `interval` is finite and above 0.
  TeachIn(Robot& robot, TaughtPath& path, double interval, std::size_t most = kMost);
  /// At triggers.
  TeachIn(Robot& robot, TaughtPath& path);

  void start() override;
  void resume() override;
  /// Notes; false. Throws NonFatalError(resources) when the path is full.
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
  Tick last_ = 0;    // to which time_ belongs
};

}  // namespace mrroc
