#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace mrroc::cli {

/// Lines that someone types at a terminal or writes into a pipe: `mrroc run`'s standard input. Of those that no one
/// takes the newest 64 KiB are kept, of a file all. One thread.
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
  /// The first of the whole lines that have come and are one of `words`, whatever the case of its letters, taken out
  /// from among the others, which stay: what may not wait behind lines that no one has asked for yet. Never waits.
  std::optional<std::string> next_of(std::initializer_list<std::string_view> words);

 private:
  void read_more();
  void forget_oldest();

  int fd_;
  bool ended_ = false;
  std::string unread_;
};

}  // namespace mrroc::cli
