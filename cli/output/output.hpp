#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

namespace mrroc::cli {

/// Text to a descriptor (stdout, stderr) that holds no one up: what a terminal that stands still or a pipe that no one
/// reads does not take is kept and tried again, the newest 1000 pieces of it, and how many were dropped is said in
/// their place. After an error (full disk, closed terminal, no one left to read) it is silent. One thread.
class Output {
 public:
  /// `fd`: not owned. SIGPIPE is to be ignored by the process.
  explicit Output(int fd);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Writes a piece of text, or keeps it for later. Never waits; an error of the descriptor is no exception.
  void write(std::string text);
  /// Writes what is kept, as far as that needs no waiting.
  void flush();
  /// The same, waiting up to `deadline_ns` of CLOCK_MONOTONIC.
  void drain(std::int64_t deadline_ns);
  /// Nothing is kept.
  bool empty() const noexcept { return kept_.empty() && written_ == text_.size(); }

 private:
  /// The next text to be written: what is kept, behind the number of what was dropped before it.
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
