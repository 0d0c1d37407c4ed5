#include "process/record/shared_black_box.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <utility>

#include "mrroc/black_box.hpp"

namespace mrroc::process {

/// All zero, as provided by the kernel, is an empty one.
struct SharedBlackBox::Memory {
  struct Entry {
    Tick tick;
    EncodedStep step;
  };
  std::atomic<std::uint64_t> written;             ///< steps since the task began
  std::atomic<std::uint64_t> file;                ///< number of the task's own black box file
  std::array<Entry, BlackBox::kSteps + 1> steps;  ///< one more than is kept: one may be half written
};

namespace {

constexpr int kAttempts = 100;  // to copy the newest step while the process records

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

void SharedBlackBox::record(Tick tick, const EncodedStep& step) noexcept {
  Memory::Entry& entry = memory_->steps[memory_->written.load(std::memory_order_relaxed) % memory_->steps.size()];
  entry.tick = tick;
  entry.step = step;
  // also before the next step: a reader detects by it that the entry is being replaced
  memory_->written.fetch_add(1, std::memory_order_acq_rel);
}

void SharedBlackBox::note_file(std::uint64_t number) noexcept { memory_->file.store(number); }

std::uint64_t SharedBlackBox::file() const noexcept { return memory_->file.load(); }

std::size_t SharedBlackBox::memory_size() noexcept { return sizeof(Memory); }

std::vector<recording::RecordedStep> SharedBlackBox::steps() const {
  std::vector<recording::RecordedStep> found;
  for (int attempt = 0; found.empty() && attempt < kAttempts; ++attempt) {
    const std::uint64_t written = memory_->written.load(std::memory_order_acquire);
    const std::uint64_t kept = std::min<std::uint64_t>(written, BlackBox::kSteps);
    // the newest first: it is replaced last
    for (std::uint64_t age = 1; age <= kept; ++age) {
      const Memory::Entry& entry = memory_->steps[(written - age) % memory_->steps.size()];
      const std::span<const std::byte> bytes = entry.step.view();
      found.push_back({entry.tick, {bytes.begin(), bytes.end()}});
      const std::uint64_t now = memory_->written.fetch_add(0, std::memory_order_acq_rel);  // not before the copy
      if (now - (written - age) < memory_->steps.size()) continue;
      found.pop_back();  // it and the older ones are being replaced
      break;
    }
    if (written == 0) break;
  }
  std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace mrroc::process
