#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

namespace mrroc::cli {

/// Text to a descriptor (stdout, stderr) that never blocks the caller. Text that a stopped terminal or a pipe without a
/// reader does not take is kept and tried again, the newest 1000 pieces of it; a line reports how many were dropped.
/// After an error (full disk, closed terminal, no reader) it is silent. One thread.
class Output {
 public:
  /// `fd`: not owned. The process must ignore SIGPIPE.
  explicit Output(int fd);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Writes a piece of text, or keeps it for later. Never waits; does not throw when the descriptor fails.
  void write(std::string text);
  /// Writes kept text as far as possible without waiting.
  void flush();
  /// The same, waiting up to `deadline_ns` of CLOCK_MONOTONIC.
  void drain(std::int64_t deadline_ns);
  /// True when no text is kept.
  bool empty() const noexcept { return kept_.empty() && written_ == text_.size(); }

 private:
  /// The next text to be written: the number of dropped lines, then the kept text.
  void take_next();

  int fd_;
  int own_;  // -1: the descriptor could not be opened again
  bool failed_ = false;
  std::string text_;         // being written
  std::size_t written_ = 0;  // of it
  std::deque<std::string> kept_;
  std::size_t dropped_ = 0;
};

}  // namespace mrroc::cli
