#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "process/record/claimed_file.hpp"

namespace mrroc::cli {

/// Where the trace of a run is written at its end: a file, or a stream, which is a FIFO, a pipe behind `/dev/fd/N`, or
/// a device. Never waits without asking whether to. Main thread.
class TraceOutput {
 public:
  /// Spends so many milliseconds on other things; returns false when the operator wants the end.
  using Wait = std::function<bool(int milliseconds)>;
  /// Is asked before each wait, and after each piece of text, with how long nothing has been taken, s; false ends it.
  using Continue = std::function<bool(double stalled)>;

  /// Opens and claims it. Waits up to `patience` s for the reader of a FIFO; when the operator ends that it is not
  /// opened. Throws std::runtime_error that names it and the reason.
  TraceOutput(const std::filesystem::path& path, double patience, const Wait& wait);

  bool opened() const noexcept { return !file_->waits(); }
  /// A regular file: what another run has left in it is removed by clear().
  bool is_file() const noexcept { return file_->is_own_regular_file(); }
  const process::ClaimedFile& file() const noexcept { return *file_; }

  void clear();
  /// Throws std::runtime_error when it cannot be written, or `go_on` ends it.
  void write(std::string_view text, const Continue& go_on);
  /// Throws std::runtime_error when it is not complete, or the path leads to another file by now.
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
