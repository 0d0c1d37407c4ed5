#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/lockfree/shared_slot.hpp"

namespace mrroc::links {

/// The last `depth` messages, passed from the listener's thread (one producer) to the participant's (one consumer):
/// message n (n = 0, 1, ...) lies in slot n modulo depth until message n + depth overwrites it. The producer never
/// waits for the consumer, so that after a pause the ring holds the newest messages, not the oldest. No lock; no
/// allocation after construction.
template <class Value>
class MessageRing {
 public:
  struct Entry {
    std::uint64_t number;
    Value value;
  };

  explicit MessageRing(std::size_t depth) : depth_(depth), slots_(std::make_unique<Slot[]>(depth)) {}

  std::size_t depth() const noexcept { return depth_; }

  /// Stores `entry.value` as the next message. Producer.
  void push(Entry& entry) noexcept {
    entry.number = pushed_.load(std::memory_order_relaxed);
    slots_[entry.number % depth_].store(entry);
    pushed_.store(entry.number + 1, std::memory_order_release);
  }

  /// Number of messages pushed. Any thread.
  std::uint64_t pushed() const noexcept { return pushed_.load(std::memory_order_acquire); }

  /// Copies message `number` (< pushed()); false when it has been overwritten. Consumer.
  bool read(std::uint64_t number, Entry& entry) const noexcept {
    return slots_[number % depth_].load(entry) && entry.number == number;
  }

 private:
  using Slot = core::SharedSlot<Entry>;
  std::size_t depth_;
  std::unique_ptr<Slot[]> slots_;
  std::atomic<std::uint64_t> pushed_{0};
};

}  // namespace mrroc::links
