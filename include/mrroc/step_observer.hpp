#pragma once

#include "mrroc/step_record.hpp"

namespace mrroc {

/// Is told every step of every Move and Wait of a task: traces, progress displays. Called when the commands have been
/// sent and no reply is awaited yet, on the task's thread: it must neither allocate, block nor throw. The record is
/// that of the task's black box: it is overwritten later.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  virtual void on_step(const StepRecord& record) noexcept = 0;
};

}  // namespace mrroc
