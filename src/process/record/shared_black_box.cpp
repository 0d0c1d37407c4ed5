#include "process/record/shared_black_box.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "mrroc/black_box.hpp"

namespace mrroc::process {

/// All zero, as provided by the kernel, is an empty one.
struct SharedBlackBox::Memory {
  std::atomic<std::uint64_t> written;                ///< lines since the task began
  std::atomic<std::uint64_t> file;                   ///< number of the task's own black box file
  std::array<TextLine, BlackBox::kSteps + 1> lines;  ///< one more than is kept: one may be half written
};

namespace {

constexpr int kAttempts = 100;  // to copy the newest line while the process records

constexpr const char* kWhat = "memory of a black box";

}  // namespace

SharedBlackBox SharedBlackBox::create() {
  return SharedBlackBox(core::SharedMemory::create("mrroc-black-box", sizeof(Memory), kWhat));
}

SharedBlackBox SharedBlackBox::attach(int fd) {
  return SharedBlackBox(core::SharedMemory::attach(fd, sizeof(Memory), kWhat));
}

SharedBlackBox::SharedBlackBox(core::SharedMemory mapped) noexcept
    : mapped_(std::move(mapped)), memory_(static_cast<Memory*>(mapped_.address())) {}

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
