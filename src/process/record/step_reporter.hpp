#pragma once

#include <memory>
#include <optional>

#include "mrroc/step_observer.hpp"
#include "process/process.hpp"
#include "process/record/shared_black_box.hpp"
#include "process/record/step_ring.hpp"
#include "process/record/trace_file.hpp"

namespace mrroc::process {

/// Reports the current step of a task to the operator, keeps the last steps in memory that outlives the process, and
/// writes the trace and hands the steps to the recording on request: one line per step, documented in
/// docs/reference/trace.md. Neither allocates nor blocks (except for a trace or a recording under a simulated clock,
/// which lose nothing).
class StepReporter : public StepObserver {
 public:
  explicit StepReporter(Process& process);
  /// An incomplete trace becomes the failure of its process.
  ~StepReporter() override;
  StepReporter(const StepReporter&) = delete;
  StepReporter& operator=(const StepReporter&) = delete;
  void on_step(const StepRecord& record) noexcept override;

 private:
  void write_line(const StepRecord& record) noexcept;

  Process& process_;
  TextLine line_;
  std::optional<SharedBlackBox> last_steps_;
  std::unique_ptr<TraceFile> trace_;
  std::optional<StepRing> ring_;
  links::Counters counters_;
  std::uint64_t steps_ = 0;  ///< of all instructions
};

/// Writes one step as a line of a trace (without the end of line).
void format_step(TextLine& line, const config::Deployment& deployment, std::string_view process,
                 const StepRecord& record) noexcept;

}  // namespace mrroc::process
