#pragma once

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "process/text_line.hpp"

namespace mrroc::process {

/// A file that lines are appended to without waiting for the disk: the task's thread hands a line over in a lock-free
/// ring, a thread of its own writes it. When the ring is full the line is dropped and counted, or, if `lossless`,
/// waited for (for clocks that do not run by the wall).
class TraceFile {
 public:
  /// `process`: whose trace it is. Throws std::runtime_error when the file cannot be written.
  TraceFile(const std::filesystem::path& path, std::string process, bool lossless);
  /// Writes what is left, and below it the remark that says how many lines there are:
  /// "# process=arm lines=463 dropped=0 cut=0", of those some were cut because they were too long.
  ~TraceFile();
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

  std::FILE* file_;
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
