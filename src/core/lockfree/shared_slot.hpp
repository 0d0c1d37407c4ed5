#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "core/lockfree/sequence_lock.hpp"

namespace mrroc::core {

/// One value in memory, shared by one writer and any number of readers, threads or processes: a sequence lock. The
/// writer is wait-free and independent of the readers; a reader retries while a write is under way and never reads a
/// torn value. No allocation, no system call. Zeroed memory is a valid empty slot.
template <class Value>
class SharedSlot {
  static_assert(std::is_trivially_copyable_v<Value>);

 public:
  /// Stores `value`. The one writer's thread.
  void store(const Value& value) noexcept {
    std::array<std::uint64_t, kWords> words{};
    std::memcpy(words.data(), &value, sizeof(Value));
    store_words(sequence_, words_, words.data());
  }

  /// Copies the newest value; false when nothing has been stored, or when the writer died in the middle of a write. Any
  /// thread.
  bool load(Value& value) const noexcept {
    std::array<std::uint64_t, kWords> words;
    if (!load_words(sequence_, words_, words.data())) return false;
    std::memcpy(static_cast<void*>(&value), words.data(), sizeof(Value));
    return true;
  }

  /// Twice the number of stores so far (odd while one is under way). Any thread.
  std::uint64_t sequence() const noexcept { return sequence_.load(std::memory_order_acquire); }

 private:
  static constexpr std::size_t kWords = (sizeof(Value) + 7) / 8;
  std::atomic<std::uint64_t> sequence_{0};
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

}  // namespace mrroc::core
