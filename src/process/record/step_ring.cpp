#include "process/record/step_ring.hpp"

#include <algorithm>
#include <cstring>

namespace mrroc::process {

namespace {

constexpr const char* kRingWhat = "memory of recorded steps";

}  // namespace

StepRing StepRing::create() { return StepRing(Ring::create("mrroc-steps", kRingWhat)); }

StepRing StepRing::attach(int fd) { return StepRing(Ring::attach(fd, kRingWhat)); }

void StepRing::add(Tick tick, const TextLine& line, bool waits) noexcept {
  Entry* const entry = ring_.claim(waits);
  if (entry == nullptr) return;
  entry->tick = tick;
  entry->size = line.view().size();
  entry->cut = line.cut();
  std::memcpy(entry->text.data(), line.view().data(), entry->size);
  ring_.publish();
}

std::optional<RecordedStep> StepRing::take() {
  const Entry* const entry = ring_.front();
  if (entry == nullptr) return std::nullopt;
  // a corrupted process may have written any size
  const std::size_t size = std::min(entry->size, entry->text.size());
  std::optional<RecordedStep> step{{entry->tick, {entry->text.data(), size}, entry->cut}};
  ring_.pop();
  return step;
}

}  // namespace mrroc::process
