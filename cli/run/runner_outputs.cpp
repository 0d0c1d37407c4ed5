// What a run leaves: its recording, without which a success is a failure, and black boxes.
#include <exception>
#include <stdexcept>
#include <string>

#include "cli/run/runner.hpp"

namespace mrroc::cli {

namespace {

constexpr double kReaderTimeout = 2;  // s without progress of a stream's reader while the operator waits

}  // namespace

void Runner::check_black_boxes() {
  const std::string problem = black_boxes_.problem();
  if (problem.empty()) return;
  const std::string text = "--black-box " + options_.black_box.string() + ": " + problem;
  if (options_.black_box_named) throw std::runtime_error(text + ", expected a folder that can be written");
  progress_.message("warning: " + text + ": a task that fails leaves no black box");
}

void Runner::close_recording(Outputs& outputs) {
  if (!recorder_) return;
  clock_.end();
  clock_.join();  // its events report to the recorder
  const std::string problem = recorder_->close(supervisor_.result());
  if (const std::string dropped = recorder_->dropped(); !dropped.empty())
    progress_.message("the recording " + options_.recording.string() + " lacks " + dropped + ": the disk was too slow");
  if (!problem.empty()) fail_by_output(process::ExitCode::system, problem);
  try {
    outputs.pass_on_recording([this](double stalled) {
      supervisor_.watch_operator(0);
      return !supervisor_.hurried() && !(supervisor_.interrupted() && stalled > kReaderTimeout);
    });
  } catch (const std::exception& error) {
    fail_by_output(supervisor_.hurried() ? process::ExitCode::stopped : process::ExitCode::system, error.what());
  }
}

void Runner::fail_by_output(process::ExitCode code, const std::string& reason) {
  if (supervisor_.result().code == process::ExitCode::success)
    supervisor_.fail(code, reason);
  else
    progress_.error("mrroc: " + deployment_.name + ": " + reason);  // not a consequence of the run's failure
}

}  // namespace mrroc::cli
