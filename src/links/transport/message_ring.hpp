#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mrroc::links {

/// The last `depth` messages, from the listener's thread (one producer) to the participant's (one consumer): message n
/// (n = 0, 1, ...) is in slot n modulo depth until message n + depth overwrites it. After a pause of the consumer the
/// newest messages are there, not the oldest. A message is written once, into the buffer in which the consumer reads
/// it: a slot is a pointer that either side exchanges for a buffer of its own. Both sides are wait-free; no allocation
/// after construction.
template <class Value>
class MessageRing {
 public:
  /// Buffers that the producer fills at a time.
  static constexpr std::size_t kIncoming = 2;

  /// `depth`: at least 1.
  explicit MessageRing(std::size_t depth) : buffers_(depth + kIncoming + 2), slots_(depth) {
    std::size_t next = 0;
    for (Slot& slot : slots_) slot.store(&buffers_[next++]);
    for (Buffer*& buffer : incoming_) buffer = &buffers_[next++];
    front_ = &buffers_[next++];
    popped_ = &buffers_[next++];
  }

  // ---- producer

  /// Where message `i` of the next ones is to be written.
  Value& incoming(std::size_t i) noexcept { return incoming_[i]->value; }

  /// Makes `incoming(i)` the next message. `incoming(i)` is another buffer afterwards.
  void push(std::size_t i) noexcept {
    const std::uint64_t number = pushed_.load(std::memory_order_relaxed);
    incoming_[i]->number = number;
    incoming_[i] = slots_[number % slots_.size()].exchange(incoming_[i], std::memory_order_acq_rel);
    pushed_.store(number + 1, std::memory_order_release);
  }

  // ---- consumer

  /// The oldest message that is there; null when there is none. It stays there until `pop`.
  const Value* front() noexcept {
    if (claimed_) return &front_->value;
    const std::uint64_t pushed = pushed_.load(std::memory_order_acquire);
    if (next_ >= pushed) return nullptr;
    if (pushed - next_ > slots_.size()) skip_to(pushed - slots_.size());
    front_ = slots_[next_ % slots_.size()].exchange(front_, std::memory_order_acq_rel);
    // the producer was a round ahead in this slot: the messages before this one are about to be overwritten
    if (front_->number != next_) skip_to(front_->number);
    claimed_ = true;
    return &front_->value;
  }

  /// Steps over `front`, which there must be, and returns it. It belongs to the consumer until the next `pop`.
  Value& pop() noexcept {
    drop();
    std::swap(front_, popped_);
    return popped_->value;
  }

  /// Steps over `front`, which there must be, without keeping it.
  void drop() noexcept {
    claimed_ = false;
    ++next_;
  }

  /// How many messages the consumer has missed because it came too late.
  std::uint64_t overwritten() const noexcept { return overwritten_; }

 private:
  struct Buffer {
    std::uint64_t number = 0;
    Value value{};
  };
  using Slot = std::atomic<Buffer*>;

  void skip_to(std::uint64_t number) noexcept {
    overwritten_ += number - next_;
    next_ = number;
  }

  std::vector<Buffer> buffers_;
  std::vector<Slot> slots_;
  std::atomic<std::uint64_t> pushed_{0};
  std::array<Buffer*, kIncoming> incoming_{};  // producer

  Buffer* front_ = nullptr;  // consumer
  Buffer* popped_ = nullptr;
  std::uint64_t next_ = 0;  // number of the oldest message not yet popped
  bool claimed_ = false;    // `front_` is message `next_`
  std::uint64_t overwritten_ = 0;
};

}  // namespace mrroc::links
