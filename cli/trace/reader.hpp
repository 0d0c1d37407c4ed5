#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <variant>

#include "cli/trace/line.hpp"
#include "recording/recording_reader.hpp"

namespace mrroc::cli::trace {

/// The end of a process's steps: mrroc_msgs/msg/ProcessEnd.
struct ProcessEnd {
  std::size_t number = 0;  ///< of its message in the file, from 1
  std::string process;
  std::uint64_t lines = 0;    ///< steps that the process has passed on
  std::uint64_t dropped = 0;  ///< that it has not, because the disk was slow
  std::uint64_t cut = 0;      ///< of `steps`: too long, the rest is missing
};

/// A recording without steps and without the end of a process: of hardware or topics only, or made by another program.
struct NoSteps : std::runtime_error {
  explicit NoSteps(const std::filesystem::path& file)
      : std::runtime_error(file.string() + ": no steps of a task, expected a recording of `mrroc run --record FILE`") {}
};

/// Reads the steps of a recording one by one, at any size: one chunk of the file is in memory at a time. One thread.
class Reader {
 public:
  /// Throws std::runtime_error when the file cannot be read or is not a recording.
  explicit Reader(const std::filesystem::path& file);

  /// Whether the run was under a simulated clock: lockstep or paced, not real.
  bool simulated() const noexcept { return simulated_; }
  /// Whether the recording has the last steps or seconds only, without the earlier ones.
  bool black_box() const noexcept { return black_box_; }
  /// The next step or end of a process; nothing (std::monostate) at the end. Throws std::runtime_error "FILE:MESSAGE:
  /// field ..." when a message is not one of a step; NoSteps at the end.
  std::variant<std::monostate, Line, ProcessEnd> next();
  /// At the end: the run has closed the recording. False: it was killed, or the disk was full.
  bool complete() const noexcept { return recording_.complete(); }

 private:
  ProcessEnd end_of(const recording::RecordedMessage& message) const;

  std::filesystem::path path_;
  recording::RecordingReader recording_;
  std::size_t number_ = 0;
  std::uint64_t period_ = 1;  // of the servo, ns
  bool simulated_ = true;
  bool black_box_ = false;
  bool last_seconds_ = false;
  bool empty_ = true;                           // neither steps nor ends so far
  std::map<std::string, std::uint64_t> steps_;  // so far, by process
};

}  // namespace mrroc::cli::trace
