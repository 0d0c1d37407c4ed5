#include "process/record/shared_black_box.hpp"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "mrroc/black_box.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::process {

/// All zero, as provided by the kernel, is an empty one.
struct SharedBlackBox::Memory {
  std::atomic<std::uint64_t> written;                ///< lines since the task began
  std::atomic<std::uint64_t> file;                   ///< number of the task's own black box file
  std::array<TextLine, BlackBox::kSteps + 1> lines;  ///< one more than is kept: one may be half written
};

namespace {

constexpr int kAttempts = 100;  // to copy the newest line while the process records

[[noreturn]] void refuse(const std::string& what) {
  throw SystemError(ErrorCode::resources, "memory of a black box: " + what);
}

}  // namespace

SharedBlackBox::Memory* SharedBlackBox::map(int fd) noexcept {
  // touch all pages now: the first step on a new one would wait for the kernel
  void* memory = mmap(nullptr, sizeof(Memory), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, fd, 0);
  return memory == MAP_FAILED ? nullptr : static_cast<Memory*>(memory);
}

SharedBlackBox SharedBlackBox::create() {
  const int fd = memfd_create("mrroc-black-box", MFD_CLOEXEC);
  if (fd < 0) refuse(std::strerror(errno));
  Memory* memory = ftruncate(fd, sizeof(Memory)) == 0 ? map(fd) : nullptr;
  if (memory == nullptr) {
    const std::string reason = std::strerror(errno);
    close(fd);
    refuse(reason);
  }
  return {memory, fd};
}

SharedBlackBox SharedBlackBox::attach(int fd) {
  struct stat status {};
  if (fstat(fd, &status) != 0 || status.st_size != static_cast<off_t>(sizeof(Memory)))
    refuse("descriptor " + std::to_string(fd) + " is not such a memory");
  Memory* memory = map(fd);
  if (memory == nullptr) refuse(std::strerror(errno));
  return {memory, -1};
}

SharedBlackBox::~SharedBlackBox() {
  if (memory_ != nullptr) munmap(memory_, sizeof(Memory));
  if (fd_ >= 0) close(fd_);
}

SharedBlackBox::SharedBlackBox(SharedBlackBox&& other) noexcept
    : memory_(std::exchange(other.memory_, nullptr)), fd_(std::exchange(other.fd_, -1)) {}

void SharedBlackBox::record(const TextLine& line) noexcept {
  memory_->lines[memory_->written.load(std::memory_order_relaxed) % memory_->lines.size()] = line;
  // also before the next line: a reader detects by it that the line is being replaced
  memory_->written.fetch_add(1, std::memory_order_acq_rel);
}

void SharedBlackBox::note_file(std::uint64_t number) noexcept { memory_->file.store(number); }

std::uint64_t SharedBlackBox::file() const noexcept { return memory_->file.load(); }

std::size_t SharedBlackBox::memory_size() noexcept { return sizeof(Memory); }

std::vector<TextLine> SharedBlackBox::lines() const {
  std::vector<TextLine> found;
  for (int attempt = 0; found.empty() && attempt < kAttempts; ++attempt) {
    const std::uint64_t written = memory_->written.load(std::memory_order_acquire);
    const std::uint64_t kept = std::min<std::uint64_t>(written, BlackBox::kSteps);
    // the newest first: it is replaced last
    for (std::uint64_t age = 1; age <= kept; ++age) {
      found.push_back(memory_->lines[(written - age) % memory_->lines.size()]);
      const std::uint64_t now = memory_->written.fetch_add(0, std::memory_order_acq_rel);  // not before the copy
      if (now - (written - age) < memory_->lines.size()) continue;
      found.pop_back();  // it and the older ones are being replaced
      break;
    }
    if (written == 0) break;
  }
  std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace mrroc::process
