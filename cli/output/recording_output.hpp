#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "process/record/claimed_file.hpp"

namespace mrroc::cli {

/// The output of a run's recording: a file or a device, written during the run, or a stream (a FIFO, a pipe behind
/// `/dev/fd/N`). A stream gets the whole recording at the end of the run, from a file in the folder for temporary
/// files: a reader that stops does not stop the run. Asks before each wait whether to continue. Main thread.
class RecordingOutput {
 public:
  /// Spends so many milliseconds on other work; returns false when the operator requests the end.
  using Wait = std::function<bool(int milliseconds)>;
  /// Called before each wait and after each piece of text, with the s since the reader last took text; false ends it.
  using Continue = std::function<bool(double stalled)>;

  /// Opens and claims it. Waits up to `timeout` s for the reader of a FIFO; when the operator ends that wait the FIFO
  /// is not opened. Throws std::runtime_error that names the output and the reason.
  RecordingOutput(const std::filesystem::path& path, double timeout, const Wait& wait);

  RecordingOutput(const RecordingOutput&) = delete;
  RecordingOutput& operator=(const RecordingOutput&) = delete;
  /// Removes the file in the folder for temporary files, unless its stream did not take it.
  ~RecordingOutput();

  bool opened() const noexcept { return !file_->waits(); }
  process::FileIdentity identity() const { return file_->identity(); }
  /// The file to write during the run.
  const process::ClaimedFile& live() const noexcept { return part_ ? *part_ : *file_; }
  /// Removes the content of an earlier run. Throws std::runtime_error when it cannot.
  void clear();
  /// At the end, when `live` is complete: passes it on to the stream, if it is one, and closes it. Throws
  /// std::runtime_error when it cannot be written, or `go_on` ends it; the message names the file in the folder for
  /// temporary files, which then stays.
  void pass_on(const Continue& go_on);

 private:
  void copy_part(const Continue& go_on);
  void write(std::string_view text, const Continue& go_on);
  [[noreturn]] void fail(const std::string& reason) const;

  std::filesystem::path path_;
  std::optional<process::ClaimedFile> file_;
  std::optional<process::ClaimedFile> part_;  // of a stream
  bool kept_ = false;                         // the stream has not taken all of it
};

/// Where a run whose recording is this file shows its progress: 1, or 2 when it is the standard output. Throws
/// std::runtime_error when the run's own text would come into the recording.
int descriptor_for_progress(const std::filesystem::path& recording);

}  // namespace mrroc::cli
