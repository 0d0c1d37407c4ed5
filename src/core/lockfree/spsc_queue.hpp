#pragma once

#include <array>
#include <atomic>
#include <cstddef>

namespace mrroc::core {

/// First-in-first-out queue between one producer's thread and one consumer's thread. Wait-free on both sides, no
/// allocation; the values are stored inline.
template <class Value, std::size_t Capacity>
class SpscQueue {
 public:
  /// False when full. Producer.
  bool push(const Value& value) noexcept {
    Value* const place = free_place();
    if (place == nullptr) return false;
    *place = value;
    push_free_place();
    return true;
  }

  /// Where the next value is to be written, or null when full; `push_free_place` then makes it the newest. Producer.
  Value* free_place() noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    return tail - head_.load(std::memory_order_acquire) == Capacity ? nullptr : &values_[tail % Capacity];
  }
  void push_free_place() noexcept { tail_.store(tail_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

  /// The oldest value, or null; it stays valid until `pop`. Consumer.
  const Value* front() const noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    return head == tail_.load(std::memory_order_acquire) ? nullptr : &values_[head % Capacity];
  }

  /// Removes the oldest value; the queue must not be empty. Consumer.
  void pop() noexcept { head_.store(head_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

 private:
  std::array<Value, Capacity> values_{};
  std::atomic<std::size_t> head_{0};
  std::atomic<std::size_t> tail_{0};
};

}  // namespace mrroc::core
