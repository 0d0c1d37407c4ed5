#pragma once

#include <optional>
#include <string>

namespace mrroc::cli {

/// Lines that somebody types at a terminal or writes into a pipe: `mrroc run`'s standard input. One thread.
class TypedLines {
 public:
  /// `fd`: not owned.
  explicit TypedLines(int fd) noexcept : fd_(fd) {}

  /// Whether a line may come: the descriptor is a terminal, a pipe or a file, and its end has not been met. /dev/null
  /// is neither.
  bool attended() const noexcept;
  /// The next whole line, without its end; the last one may lack it. Never waits, and leaves a terminal alone while
  /// this process is in its background.
  std::optional<std::string> next();

 private:
  void read_more();

  int fd_;
  bool ended_ = false;
  std::string unread_;
};

}  // namespace mrroc::cli
