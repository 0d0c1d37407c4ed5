#pragma once

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The robot stays at its desired state for `duration` seconds of ticks (rounded up to whole steps).
class Hold : public Generator {
 public:
  /// Throws NonFatalError(invalid_argument) unless `duration` is finite and not negative.
  Hold(Robot& robot, double duration);

  void start() override;
  /// A pause does not count as holding time.
  void resume() override;
  bool terminal_condition() override;
  /// Writes nothing: a robot without a command holds.
  void next_state() override {}

 private:
  Robot* robot_;
  double duration_;
  double held_ = 0;  // s, since the start
  Tick last_tick_ = 0;
};

}  // namespace mrroc
