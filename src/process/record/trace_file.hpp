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

/// How the reason begins why a trace is not complete; its name and the system's reason follow.
inline constexpr std::string_view kTraceProblem = "cannot write the trace ";

/// A file that lines are appended to without waiting for the disk: the task's thread hands a line over in a lock-free
/// ring, a thread of its own writes it. When the ring is full the line is dropped and counted, or, if `lossless`,
/// waited for (for clocks that do not run by the wall).
class TraceFile {
 public:
  /// Creates the file. `process`: whose trace it is. Throws std::runtime_error when the file cannot be written.
  TraceFile(const std::filesystem::path& path, std::string process, bool lossless);
  /// The same into an open file, whose descriptor stays the caller's; `path` is its name in messages.
  TraceFile(int fd, std::filesystem::path path, std::string process, bool lossless);
  /// As close(), without the reason.
  ~TraceFile();
  /// Writes the remaining lines, and below them the remark that says how many lines there are: "# process=arm lines=463
  /// dropped=0 cut=0", of those some were cut because they were too long. Returns why the trace is not complete:
  /// "cannot write the trace t: No space left on device"; empty: it is. After an error nothing more is written. One
  /// thread, after the last commit(); once.
  std::string close();
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;

  /// The line to fill next; null when it has to be dropped. One thread.
  TextLine* begin() noexcept;
  /// Hands the line of the last `begin()` over.
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
  std::atomic<std::uint64_t> signals_{0};  // what the file's thread sleeps on: lines and the end
  std::atomic<bool> ended_{false};
  std::uint64_t dropped_ = 0;
  std::uint64_t cut_ = 0;
  std::thread thread_;
};

}  // namespace mrroc::process
