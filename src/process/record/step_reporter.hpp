#pragma once

#include <optional>

#include "mrroc/step_observer.hpp"
#include "process/process.hpp"
#include "process/record/encoded_step.hpp"
#include "process/record/shared_black_box.hpp"
#include "process/record/step_ring.hpp"

namespace mrroc::process {

/// Reports the current step of a task to the operator, keeps the last steps in memory that outlives the process, and
/// on request hands every step to the recording (docs/reference/recording.md). Neither allocates nor blocks (except for
/// a recording under a simulated clock, which loses nothing).
class StepReporter : public StepObserver {
 public:
  explicit StepReporter(Process& process);
  /// Marks the end of the steps.
  ~StepReporter() override;
  StepReporter(const StepReporter&) = delete;
  StepReporter& operator=(const StepReporter&) = delete;
  void on_step(const StepRecord& record) noexcept override;

 private:
  void pass_on(const StepRecord& record) noexcept;

  Process& process_;
  EncodedStep step_;
  std::optional<SharedBlackBox> last_steps_;
  std::optional<StepRing> ring_;
  links::Counters counters_;
  std::uint64_t steps_ = 0;  ///< of all instructions
};

}  // namespace mrroc::process
