#include "cli/operator/terminal/console_input.hpp"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace mrroc::cli {

namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kTyped = 65536;  // more than an operator types; a pipe may hold more

}  // namespace

ConsoleInput::ConsoleInput(int fd, bool keys) : fd_(fd) {
  if (keys) mode_.emplace(fd);
}

bool ConsoleInput::attended() const noexcept {
  if (!unread_.empty()) return true;
  if (ended_) return false;
  struct stat status {};
  if (fstat(fd_, &status) != 0) return false;
  return isatty(fd_) != 0 || S_ISFIFO(status.st_mode) || S_ISREG(status.st_mode) || S_ISSOCK(status.st_mode);
}

std::optional<std::string> ConsoleInput::next() {
  read_more();
  const std::size_t end = unread_.find('\n');
  if (end == std::string::npos && (!ended_ || unread_.empty())) return std::nullopt;
  std::string line = unread_.substr(0, end);
  unread_.erase(0, end == std::string::npos ? end : end + 1);
  return line;
}

std::optional<std::string> ConsoleInput::next_if(const std::function<bool(std::string_view line)>& wanted) {
  read_more();
  std::size_t begin = 0;
  for (std::size_t end = 0; begin < unread_.size(); begin = end + 1) {
    end = unread_.find('\n', begin);
    if (end == std::string::npos && !ended_) break;  // the line is being typed
    end = std::min(end, unread_.size());
    std::string_view line = std::string_view{unread_}.substr(begin, end - begin);
    if (line != " ") {  // the space key
      line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
      line = line.substr(0, line.find_last_not_of(kBlanks) + 1);
    }
    if (!wanted(line)) continue;
    std::string taken{line};
    unread_.erase(begin, end + 1 - begin);
    return taken;
  }
  return std::nullopt;
}

/// Drops the oldest text: unrequested lines must not delay an emergency stop behind them.
void ConsoleInput::forget_oldest() {
  const std::size_t end = unread_.find('\n', unread_.size() - kTyped);
  unread_.erase(0, end == std::string::npos ? end : end + 1);
}

/// Reads what has arrived; of a file, a part.
void ConsoleInput::read_more() {
  // reading a terminal from the background would stop this process, and the deployment with it
  if (isatty(fd_) != 0 && tcgetpgrp(fd_) != getpgrp()) return;
  struct stat status {};
  const bool is_file = fstat(fd_, &status) == 0 && S_ISREG(status.st_mode);
  if (is_file && unread_.size() >= kTyped) return;  // a file is not typed, and the rest can be read later
  std::array<char, 256> buffer;
  std::size_t taken = 0;
  for (pollfd entry{fd_, POLLIN, 0}; !ended_ && taken < kTyped && poll(&entry, 1, 0) > 0;) {
    const ssize_t count = read(fd_, buffer.data(), buffer.size());
    if (count == 0 && isatty(fd_) != 0) break;  // Ctrl-D ends a line there, not the typing
    ended_ = count <= 0;
    if (count <= 0) break;
    const std::string_view text(buffer.data(), static_cast<std::size_t>(count));
    if (takes_keys())
      unread_ += editor_.feed(text);
    else
      unread_ += text;
    taken += static_cast<std::size_t>(count);
  }
  if (unread_.size() > kTyped) forget_oldest();
}

}  // namespace mrroc::cli
