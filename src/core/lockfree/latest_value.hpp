#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace mrroc::core {

/// The newest value from one writer's thread to one reader's thread: a triple buffer. Wait-free on both sides, no
/// allocation, never torn. Unlike SharedSlot it carries any copyable type, but only inside one process.
template <class Value>
class LatestValue {
 public:
  /// Writer.
  void store(const Value& value) noexcept {
    slots_[back_] = value;
    back_ = static_cast<std::uint8_t>(middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex);
  }

  /// The newest value, or null when nothing has been stored yet; stays valid and unchanged until the next `load`.
  /// Reader.
  const Value* load() noexcept {
    if (middle_.load(std::memory_order_relaxed) & kFresh) {
      front_ = static_cast<std::uint8_t>(middle_.exchange(front_, std::memory_order_acq_rel) & kIndex);
      filled_ = true;
    }
    return filled_ ? &slots_[front_] : nullptr;
  }

 private:
  static constexpr unsigned kFresh = 4, kIndex = 3;
  std::array<Value, 3> slots_{};
  std::uint8_t back_ = 0;            // writer's own
  std::atomic<unsigned> middle_{1};  // in transit, kFresh when not yet read
  std::uint8_t front_ = 2;           // reader's own
  bool filled_ = false;              // reader's own
};

}  // namespace mrroc::core
