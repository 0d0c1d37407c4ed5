#pragma once

#include "mrroc/step_record.hpp"

namespace mrroc {

/// Receives every step of every Move and Wait of a task: traces, progress displays. Called on the task's thread after
/// the commands have been sent and before the replies are awaited; it must neither allocate, block nor throw. The
/// record belongs to the task's black box and is overwritten later.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  virtual void on_step(const StepRecord& record) noexcept = 0;
};

}  // namespace mrroc
