#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/output/recording_output.hpp"
#include "cli/processes/process_plan.hpp"
#include "cli/run/run_options.hpp"
#include "config/deployment.hpp"
#include "process/record/claimed_file.hpp"

namespace mrroc::cli {

/// All files and folders that a run writes by name, claimed before anything starts: no other run uses one of them, none
/// is named twice, and none is a file of the deployment. Main thread.
class Outputs {
 public:
  /// Throws std::runtime_error that names the option, the file and the reason; then nothing has been emptied. `wait`:
  /// see RecordingOutput.
  Outputs(const RunOptions& options, const config::Deployment& deployment, const RecordingOutput::Wait& wait);

  /// Removes the content of an earlier run: from now on the outputs belong to this run.
  void begin();

  /// The open motion file, the open file of noted events; -1 without one.
  int motion() const noexcept { return motion_ ? motion_->fd() : -1; }
  int notes() const noexcept { return notes_ ? notes_->fd() : -1; }
  /// The open file for the recording; null: none is written.
  const process::ClaimedFile* recording() const noexcept {
    return recording_ && recording_->opened() ? &recording_->live() : nullptr;
  }
  /// At the end of the run, when the recording is complete. Throws as RecordingOutput::pass_on.
  void pass_on_recording(const RecordingOutput::Continue& go_on);

 private:
  /// Throws std::runtime_error when the file holds something else than the option writes: an input would be lost.
  static void check_replaceable(const std::string& option, const std::filesystem::path& path,
                                std::string_view beginning, const std::string& kind);
  void check_apart(const std::string& option, const std::filesystem::path& path) const;

  std::vector<std::pair<std::string, process::FileIdentity>> known_;  // files that no further output may be
  std::optional<process::ClaimedFile> motion_;
  std::optional<process::ClaimedFile> notes_;
  std::optional<RecordingOutput> recording_;
  bool record_last_ = false;
  std::optional<process::ClaimedFile> snapshots_;
};

/// A file that is written during the run: a regular file or a device. `option`: as typed;
/// `what`: its name in messages. Throws std::runtime_error for another, or as ClaimedFile.
process::ClaimedFile claim_live(const std::filesystem::path& path, const std::string& option, const std::string& what);

}  // namespace mrroc::cli
