#include "cli/hosts/line_channel.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace mrroc::cli {

namespace {

/// A peer that sends more than this without an end of line does not follow the protocol.
constexpr std::size_t kLongestLine = 1 << 20;

}  // namespace

LineChannel::LineChannel(int in, int out) : in_(in), out_(out) {
  for (const int fd : {in_, out_}) fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_NONBLOCK);
}

LineChannel::~LineChannel() {
  close(in_);
  if (out_ >= 0 && out_ != in_) close(out_);
}

std::vector<std::string> LineChannel::read() {
  char buffer[65536];
  ssize_t size = 0;
  while (!closed_ && (size = ::read(in_, buffer, sizeof buffer)) != 0) {
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    if (size < 0 || (incoming_.size() > kLongestLine && incoming_.find('\n') == std::string::npos)) {
      closed_ = true;
      break;
    }
    incoming_.append(buffer, static_cast<std::size_t>(size));
    if (incoming_.size() > 2 * kLongestLine) break;  // a peer that never stops writing must not block the reader
  }
  if (size == 0) closed_ = true;
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = incoming_.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(incoming_.substr(begin, end - begin));
  incoming_.erase(0, begin);
  return lines;
}

void LineChannel::write(const std::string& line) {
  std::string one = line;
  std::replace(one.begin(), one.end(), '\n', ' ');
  outgoing_ += one + "\n";
  flush();
}

void LineChannel::flush() {
  while (waiting() > 0 && out_ >= 0) {
    const char* const text = outgoing_.data() + sent_;
    // without SIGPIPE when the peer is gone; the owner of a pipe ignores that signal
    ssize_t size = ::send(out_, text, waiting(), MSG_NOSIGNAL);
    if (size < 0 && errno == ENOTSOCK) size = ::write(out_, text, waiting());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    // the peer is gone; `read` sees the end
    sent_ = size <= 0 ? outgoing_.size() : sent_ + static_cast<std::size_t>(size);
  }
  // rarely, because it moves the remaining text
  if (sent_ < outgoing_.size() && sent_ < outgoing_.size() / 2) return;
  outgoing_.erase(0, sent_);
  sent_ = 0;
}

void LineChannel::finish() noexcept {
  if (out_ < 0) return;
  if (shutdown(out_, SHUT_WR) != 0 && out_ != in_) close(out_);
  out_ = -1;
}

}  // namespace mrroc::cli
