// What a run leaves: its trace and its recording. A success without them is a failure.
#include <exception>
#include <string>

#include "cli/run/runner.hpp"
#include "process/record/trace_file.hpp"

namespace mrroc::cli {

namespace {

constexpr double kTraceReaderTimeout = 2;  // s without progress of the trace's reader while the operator waits

}  // namespace

void Runner::join_trace(Outputs& outputs) {
  for (const PlannedProcess& process : plan_) {
    const Child* const child = group_.find(process.name);
    // the last report of a task that could not write its part
    if (child != nullptr && child->exit_code() == static_cast<int>(process::ExitCode::system) &&
        child->last_line().starts_with(process::kTraceProblem))
      supervisor_.fail(process::ExitCode::system, child->last_line());
  }
  try {
    outputs.join_trace(deployment_.clock, [this](double stalled) {
      supervisor_.watch_operator(0);
      return !supervisor_.hurried() && !(supervisor_.interrupted() && stalled > kTraceReaderTimeout);
    });
  } catch (const std::exception& error) {
    fail_by_output(supervisor_.hurried() ? process::ExitCode::stopped : process::ExitCode::system, error.what());
  }
}

void Runner::close_recording() {
  if (!recorder_) return;
  clock_.end();
  clock_.join();  // its events report to the recorder
  const std::string problem = recorder_->close(supervisor_.result());
  if (const std::string dropped = recorder_->dropped(); !dropped.empty())
    progress_.message("the recording " + options_.recording.string() + " lacks " + dropped + ": the disk was too slow");
  if (!problem.empty()) fail_by_output(process::ExitCode::system, problem);
}

void Runner::fail_by_output(process::ExitCode code, const std::string& reason) {
  if (supervisor_.result().code == process::ExitCode::success)
    supervisor_.fail(code, reason);
  else
    progress_.error("mrroc: " + deployment_.name + ": " + reason);  // not a consequence of the run's failure
}

}  // namespace mrroc::cli
