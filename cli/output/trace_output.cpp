#include "cli/output/trace_output.hpp"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <stdexcept>
#include <string>

#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

constexpr const char* kWhat = "the trace";
constexpr int kGlance = 20;  // ms between two checks whether to continue

/// Whether `fd` and the path lead to one file in which the text of two writers would mix.
bool would_mix(int fd, const std::filesystem::path& path) {
  struct stat status {};
  if (fstat(fd, &status) != 0 || (S_ISCHR(status.st_mode) && isatty(fd) == 0)) return false;
  return process::identity_of(fd) == process::identity_of(path);
}

}  // namespace

TraceOutput::TraceOutput(const std::filesystem::path& path, double patience, const Wait& wait) : path_(path) {
  const std::int64_t deadline = clock::monotonic_ns() + static_cast<std::int64_t>(patience * 1e9);
  for (;;) {
    file_.emplace(path, kWhat);
    if (opened()) return;
    if (clock::monotonic_ns() > deadline)
      throw std::runtime_error("the trace " + path_.string() +
                               ": no process reads the FIFO, expected a reader within " +
                               std::to_string(static_cast<int>(patience)) + " s");
    if (!wait(kGlance)) return;
  }
}

void TraceOutput::clear() {
  if (is_file() && ftruncate(file_->fd(), 0) != 0) fail(std::strerror(errno));
}

void TraceOutput::write(std::string_view text, const Continue& go_on) {
  std::int64_t taken = clock::monotonic_ns();
  while (!text.empty()) {
    pollfd output{file_->fd(), POLLOUT, 0};
    if (poll(&output, 1, kGlance) == 0) {
      if (!go_on(static_cast<double>(clock::monotonic_ns() - taken) * 1e-9)) fail("ended by the operator");
      continue;
    }
    // no more than a pipe takes at once: an inherited descriptor may block
    const std::size_t most = is_file() ? text.size() : std::min<std::size_t>(text.size(), PIPE_BUF);
    const ssize_t size = ::write(file_->fd(), text.data(), most);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (size <= 0) fail(size < 0 ? std::strerror(errno) : "nothing was taken");
    text.remove_prefix(static_cast<std::size_t>(size));
    taken = clock::monotonic_ns();
  }
  if (!go_on(0)) fail("ended by the operator");
}

void TraceOutput::close() {
  if (is_file() && !file_->in_place()) fail("another file has taken its place, or it was removed");
  if (const int problem = file_->close(); problem != 0) fail(std::strerror(problem));
}

void TraceOutput::fail(const std::string& reason) const {
  throw std::runtime_error("cannot write the trace " + path_.string() + ": " + reason);
}

int descriptor_for_progress(const std::filesystem::path& trace) {
  if (trace.empty()) return STDOUT_FILENO;
  const bool out = would_mix(STDOUT_FILENO, trace), err = would_mix(STDERR_FILENO, trace);
  if (err)
    throw std::runtime_error("the trace " + trace.string() + ": is where the run " +
                             (out ? "shows its progress and its errors" : "reports its errors") +
                             ", expected another file");
  return out ? STDERR_FILENO : STDOUT_FILENO;
}

}  // namespace mrroc::cli
