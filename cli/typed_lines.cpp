#include "cli/typed_lines.hpp"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>

namespace mrroc::cli {

bool TypedLines::attended() const noexcept {
  if (!unread_.empty()) return true;
  if (ended_) return false;
  struct stat status {};
  if (fstat(fd_, &status) != 0) return false;
  return isatty(fd_) != 0 || S_ISFIFO(status.st_mode) || S_ISREG(status.st_mode) || S_ISSOCK(status.st_mode);
}

std::optional<std::string> TypedLines::next() {
  read_more();
  const std::size_t end = unread_.find('\n');
  if (end == std::string::npos && (!ended_ || unread_.empty())) return std::nullopt;
  std::string line = unread_.substr(0, end);
  unread_.erase(0, end == std::string::npos ? end : end + 1);
  return line;
}

void TypedLines::read_more() {
  // reading a terminal from the background would stop this process, and the deployment with it
  if (isatty(fd_) != 0 && tcgetpgrp(fd_) != getpgrp()) return;
  std::array<char, 256> buffer;
  for (pollfd look{fd_, POLLIN, 0}; !ended_ && unread_.find('\n') == std::string::npos && poll(&look, 1, 0) > 0;) {
    const ssize_t count = read(fd_, buffer.data(), buffer.size());
    if (count > 0) unread_.append(buffer.data(), static_cast<std::size_t>(count));
    ended_ = count <= 0;
  }
}

}  // namespace mrroc::cli
