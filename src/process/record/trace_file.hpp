#pragma once

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "process/record/text_line.hpp"

namespace mrroc::process {

/// The beginning of the reason why a trace is not complete; its name and the system's reason follow.
inline constexpr std::string_view kTraceProblem = "cannot write the trace ";

/// A file to which lines are appended without waiting for the disk: the task's thread passes a line through a lock-free
/// ring to a separate thread that writes it. When the ring is full the line is dropped and counted, or, if `lossless`,
/// the task's thread waits (for clocks other than the wall clock).
class TraceFile {
 public:
  /// Creates the file. `process`: the process of the trace. Throws std::runtime_error when the file cannot be written.
  TraceFile(const std::filesystem::path& path, std::string process, bool lossless);
  /// The same into an open file, whose descriptor stays the caller's; `path` is its name in messages.
  TraceFile(int fd, std::filesystem::path path, std::string process, bool lossless);
  /// As close(), without the reason.
  ~TraceFile();
  /// Writes the remaining lines, and below them a comment with the number of lines: "# process=arm lines=463 dropped=0
  /// cut=0"; cut: lines that were too long. Returns the reason why the trace is not complete: "cannot write the trace
  /// t: No space left on device"; empty if it is complete. After an error nothing more is written. One thread, after
  /// the last commit(); once.
  std::string close();
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;

  /// The line to fill next; null when it has to be dropped. One thread.
  TextLine* begin() noexcept;
  /// Passes on the line of the last `begin()`.
  void commit() noexcept;

 private:
  static constexpr std::size_t kLines = 256;
  void run();
  void wake() noexcept;
  void drain();
  void write(std::string_view text) noexcept;

  std::filesystem::path path_;
  std::FILE* file_;
  int failure_ = 0;  // errno of the first write that failed; by the file's thread, until it is joined
  std::string process_;
  bool lossless_;
  std::vector<TextLine> ring_;
  std::atomic<std::uint64_t> written_{0};  // by the task's thread
  std::atomic<std::uint64_t> read_{0};     // by the file's thread
  std::atomic<std::uint64_t> signals_{0};  // the file's thread sleeps on it: lines and the end
  std::atomic<bool> ended_{false};
  std::uint64_t dropped_ = 0;
  std::uint64_t cut_ = 0;
  std::thread thread_;
};

}  // namespace mrroc::process
