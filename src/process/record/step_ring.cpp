#include "process/record/step_ring.hpp"

#include <algorithm>
#include <cstring>

namespace mrroc::process {

namespace {

constexpr const char* kRingWhat = "memory of recorded steps";

}  // namespace

StepRing StepRing::create() { return StepRing(Ring::create("mrroc-steps", kRingWhat)); }

StepRing StepRing::attach(int fd) { return StepRing(Ring::attach(fd, kRingWhat)); }

void StepRing::add(Tick tick, const EncodedStep& step, bool waits) noexcept {
  Entry* const entry = ring_.claim(waits);
  if (entry == nullptr) return;
  entry->tick = tick;
  entry->size = step.view().size();
  std::memcpy(entry->bytes.data(), step.view().data(), entry->size);
  ring_.publish();
}

std::optional<recording::RecordedStep> StepRing::take() {
  const Entry* const entry = ring_.front();
  if (entry == nullptr) return std::nullopt;
  // a corrupted process may write any size, at any time
  const volatile std::size_t& shared = entry->size;
  const std::size_t now = shared, size = std::min(now, entry->bytes.size());
  std::optional<recording::RecordedStep> step{
      {entry->tick, {entry->bytes.begin(), entry->bytes.begin() + static_cast<std::ptrdiff_t>(size)}}};
  ring_.pop();
  return step;
}

}  // namespace mrroc::process
