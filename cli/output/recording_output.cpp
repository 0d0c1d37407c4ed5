#include "cli/output/recording_output.hpp"

#include <poll.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
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

constexpr const char* kWhat = "the recording";
constexpr int kGlance = 20;            // ms between two checks whether to continue
constexpr std::size_t kPiece = 65536;  // bytes

constexpr unsigned kMemoryDevices = 1;  // major number of /dev/null and the like: they never wait

/// Whether it is written at the end only: its reader may stop, or it is slow.
bool is_stream(int fd) {
  struct stat status {};
  if (fstat(fd, &status) != 0) return false;
  const bool device = S_ISCHR(status.st_mode) && major(status.st_rdev) != kMemoryDevices;
  return device || S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode);
}

process::ClaimedFile new_part() {
  const auto name = [](std::uint64_t number) {
    std::string file = std::filesystem::temp_directory_path() / ("mrroc-" + std::to_string(getpid()));
    if (number > 1) file.append(".").append(std::to_string(number));
    return file.append(".part");
  };
  return process::ClaimedFile::create(name, kWhat);
}

/// Whether `fd` and the path lead to one file in which the text of two writers would mix.
bool would_mix(int fd, const std::filesystem::path& path) {
  struct stat status {};
  if (fstat(fd, &status) != 0 || (S_ISCHR(status.st_mode) && isatty(fd) == 0)) return false;
  return process::identity_of(fd) == process::identity_of(path);
}

}  // namespace

RecordingOutput::RecordingOutput(const std::filesystem::path& path, double timeout, const Wait& wait) : path_(path) {
  const std::int64_t deadline = clock::monotonic_ns() + static_cast<std::int64_t>(timeout * 1e9);
  for (;;) {
    file_.emplace(path, kWhat);
    if (opened()) break;
    if (clock::monotonic_ns() > deadline)
      throw std::runtime_error("the recording " + path_.string() +
                               ": no process reads the FIFO, expected a reader within " +
                               std::to_string(static_cast<int>(timeout)) + " s");
    if (!wait(kGlance)) return;
  }
  if (is_stream(file_->fd())) part_.emplace(new_part());
}

RecordingOutput::~RecordingOutput() {
  std::error_code ignored;
  if (part_ && !kept_ && part_->in_place()) std::filesystem::remove(part_->path(), ignored);
}

void RecordingOutput::clear() {
  if (file_->is_own_regular_file() && ftruncate(file_->fd(), 0) != 0) fail(std::strerror(errno));
}

void RecordingOutput::pass_on(const Continue& go_on) {
  if (part_) copy_part(go_on);
  if (const int problem = file_->close(); problem != 0) fail(std::strerror(problem));
  kept_ = false;
}

void RecordingOutput::copy_part(const Continue& go_on) {
  kept_ = true;  // until the stream has all of it
  std::string piece(kPiece, '\0');
  for (off_t done = 0;;) {
    const ssize_t size = pread(part_->fd(), piece.data(), piece.size(), done);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) fail(std::strerror(errno));
    if (size == 0) break;
    write(std::string_view{piece}.substr(0, static_cast<std::size_t>(size)), go_on);
    done += size;
  }
}

void RecordingOutput::write(std::string_view text, const Continue& go_on) {
  std::int64_t taken = clock::monotonic_ns();
  while (!text.empty()) {
    pollfd output{file_->fd(), POLLOUT, 0};
    if (poll(&output, 1, kGlance) == 0) {
      if (!go_on(static_cast<double>(clock::monotonic_ns() - taken) * 1e-9)) fail("ended by the operator");
      continue;
    }
    // no more than a pipe takes at once: an inherited descriptor may block
    const std::size_t most = std::min<std::size_t>(text.size(), PIPE_BUF);
    const ssize_t size = ::write(file_->fd(), text.data(), most);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (size <= 0) fail(size < 0 ? std::strerror(errno) : "nothing was taken");
    text.remove_prefix(static_cast<std::size_t>(size));
    taken = clock::monotonic_ns();
  }
  if (!go_on(0)) fail("ended by the operator");
}

void RecordingOutput::fail(const std::string& reason) const {
  throw std::runtime_error("cannot write the recording " + path_.string() + ": " + reason +
                           (kept_ ? "; it is in " + part_->path().string() : ""));
}

int descriptor_for_progress(const std::filesystem::path& recording) {
  if (recording.empty()) return STDOUT_FILENO;
  const bool out = would_mix(STDOUT_FILENO, recording), err = would_mix(STDERR_FILENO, recording);
  if (err)
    throw std::runtime_error("the recording " + recording.string() + ": is where the run " +
                             (out ? "shows its progress and its errors" : "reports its errors") +
                             ", expected another file");
  return out ? STDERR_FILENO : STDOUT_FILENO;
}

}  // namespace mrroc::cli
