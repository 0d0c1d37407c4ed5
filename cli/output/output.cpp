#include "cli/output/output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <utility>

#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

constexpr std::size_t kMostKept = 1000;

/// Opens a terminal or pipe again, non-blocking: that flag on the inherited descriptor would affect every process that
/// shares it. -1: the descriptor is another kind of file, or cannot be opened.
int open_anew(int fd) {
  struct stat status {};
  if (fstat(fd, &status) != 0 || (!S_ISFIFO(status.st_mode) && isatty(fd) == 0)) return -1;
  return ::open(fmt::format("/proc/self/fd/{}", fd).c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

}  // namespace

Output::Output(int fd) : fd_(fd), own_(open_anew(fd)) {}

Output::~Output() {
  if (own_ >= 0) close(own_);
}

void Output::write(std::string text) {
  if (failed_ || text.empty()) return;
  kept_.push_back(std::move(text));
  flush();
  if (kept_.size() <= kMostKept) return;
  kept_.pop_front();
  ++dropped_;
}

void Output::flush() {
  const int fd = own_ >= 0 ? own_ : fd_;
  while (!empty()) {
    pollfd entry{fd, POLLOUT, 0};
    if (poll(&entry, 1, 0) <= 0) return;
    if (written_ == text_.size()) take_next();
    // no more than a pipe takes at once
    const ssize_t size = ::write(fd, text_.data() + written_, std::min<std::size_t>(text_.size() - written_, PIPE_BUF));
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size <= 0) {
      failed_ = true;
      kept_.clear();
      written_ = text_.size();
      return;
    }
    written_ += static_cast<std::size_t>(size);
  }
}

void Output::take_next() {
  written_ = 0;
  if (dropped_ > 0) {
    text_ = fmt::format("({} lines are lost: the output did not take them)\n", std::exchange(dropped_, 0));
    return;
  }
  text_ = std::move(kept_.front());
  kept_.pop_front();
}

void Output::drain(std::int64_t deadline_ns) {
  constexpr int kPause = 10;  // ms
  flush();
  while (!empty() && clock::monotonic_ns() < deadline_ns) {
    pollfd entry{own_ >= 0 ? own_ : fd_, POLLOUT, 0};
    poll(&entry, 1, kPause);
    flush();
  }
}

}  // namespace mrroc::cli
