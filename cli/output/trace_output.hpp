#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "process/record/claimed_file.hpp"

namespace mrroc::cli {

/// The output of a run's trace, written at the end of the run: a file, or a stream (a FIFO, a pipe behind `/dev/fd/N`,
/// or a device). Asks before each wait whether to continue. Main thread.
class TraceOutput {
 public:
  /// Spends so many milliseconds on other work; returns false when the operator requests the end.
  using Wait = std::function<bool(int milliseconds)>;
  /// Called before each wait and after each piece of text, with the s since the reader last took text; false ends it.
  using Continue = std::function<bool(double stalled)>;

  /// Opens and claims it. Waits up to `patience` s for the reader of a FIFO; when the operator ends that wait the FIFO
  /// is not opened. Throws std::runtime_error that names the output and the reason.
  TraceOutput(const std::filesystem::path& path, double patience, const Wait& wait);

  bool opened() const noexcept { return !file_->waits(); }
  /// True for a regular file: clear() removes the content of an earlier run.
  bool is_file() const noexcept { return file_->is_own_regular_file(); }
  const process::ClaimedFile& file() const noexcept { return *file_; }

  void clear();
  /// Throws std::runtime_error when it cannot be written, or `go_on` ends it.
  void write(std::string_view text, const Continue& go_on);
  /// Throws std::runtime_error when it is not complete, or the path now leads to another file.
  void close();

 private:
  [[noreturn]] void fail(const std::string& reason) const;

  std::filesystem::path path_;
  std::optional<process::ClaimedFile> file_;
};

/// Where a run whose trace is this file shows its progress: 1, or 2 when the trace is the standard output. Throws
/// std::runtime_error when the run's own text would come between the lines of the trace.
int descriptor_for_progress(const std::filesystem::path& trace);

}  // namespace mrroc::cli
