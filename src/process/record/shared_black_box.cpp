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
  memory_->written.fetch_add(1, std::memory_order_release);
}

void SharedBlackBox::note_file(std::uint64_t number) noexcept { memory_->file.store(number); }

std::uint64_t SharedBlackBox::file() const noexcept { return memory_->file.load(); }

std::size_t SharedBlackBox::memory_size() noexcept { return sizeof(Memory); }

std::vector<TextLine> SharedBlackBox::lines() const {
  const std::uint64_t written = memory_->written.load(std::memory_order_acquire);
  std::vector<TextLine> found;
  for (std::uint64_t i = written - std::min<std::uint64_t>(written, BlackBox::kSteps); i < written; ++i)
    found.push_back(memory_->lines[i % memory_->lines.size()]);
  return found;
}

}  // namespace mrroc::process
