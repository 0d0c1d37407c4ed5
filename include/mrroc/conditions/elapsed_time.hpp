#pragma once

#include "mrroc/condition.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

class Task;

/// `seconds` have passed since the instruction began, in the deployment's time (simulated time under lockstep), in
/// whole servo ticks. A timeout: pauses count too. `ElapsedSteps` counts executed steps instead.
class ElapsedTime : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `seconds` is finite and not negative.
  ElapsedTime(const Task& task, double seconds);

  void start() override;

 protected:
  bool holds() override;

 private:
  const Task* task_;
  double seconds_;
  Tick origin_ = 0;
};

}  // namespace mrroc
