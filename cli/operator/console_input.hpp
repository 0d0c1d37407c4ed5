#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace mrroc::cli {

/// Lines that the operator types at a terminal or a process writes into a pipe: `mrroc run`'s standard input. Keeps the
/// newest 64 KiB of the lines that were not taken; of a file, all. One thread.
class ConsoleInput {
 public:
  /// `fd`: not owned.
  explicit ConsoleInput(int fd) noexcept : fd_(fd) {}

  /// Whether a line may come: the descriptor is a terminal, a pipe or a file (not /dev/null), and its end has not been
  /// reached.
  bool attended() const noexcept;
  /// The next whole line, without its end; the last one may lack it. Never waits, and does not read a terminal while
  /// this process is in its background.
  std::optional<std::string> next();
  /// Removes and returns the first whole line that is one of `words`, in upper or lower case; other lines
  /// stay. For commands that must not wait behind lines that nothing has requested yet. Never waits.
  std::optional<std::string> next_of(std::initializer_list<std::string_view> words);

 private:
  void read_more();
  void forget_oldest();

  int fd_;
  bool ended_ = false;
  std::string unread_;
};

}  // namespace mrroc::cli
