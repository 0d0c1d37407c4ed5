#pragma once

#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <variant>

#include "cli/trace/line.hpp"

namespace mrroc::cli::trace {

/// The remark "# process=arm lines=463 dropped=0 cut=0" below a process's last line.
struct Remark {
  std::size_t number = 0;  ///< of its line in the file, from 1
  std::string process;
  std::uint64_t lines = 0;    ///< that the process has written
  std::uint64_t dropped = 0;  ///< that it has not written, because the disk was slow
  std::uint64_t cut = 0;      ///< of `lines`: too long, the rest is missing
};

/// Reads a trace line by line, at any size: one line is in memory at a time.
class Reader {
 public:
  /// Throws std::runtime_error when the file cannot be read or is not a trace.
  explicit Reader(std::filesystem::path file);
  /// Reads the text of a trace. `name`: of the file in messages. Throws as the other one.
  Reader(std::filesystem::path name, std::string text);

  /// Whether the trace was written under a simulated clock: lockstep or paced, not real.
  bool simulated() const noexcept { return simulated_; }
  /// Whether the trace is a black box: the last lines of a process, without the earlier ones.
  bool black_box() const noexcept { return black_box_; }
  /// The next line or remark; nothing (std::monostate) at the end. Throws std::runtime_error "FILE:LINE: field ..."
  /// when it does not follow the format.
  std::variant<std::monostate, Line, Remark> next();

 private:
  Reader(std::filesystem::path path, std::unique_ptr<std::istream> stream);
  bool read();

  std::filesystem::path path_;
  std::unique_ptr<std::istream> file_;
  std::string text_;
  std::size_t number_ = 0;
  bool simulated_ = true;
  bool black_box_ = false;
};

}  // namespace mrroc::cli::trace
