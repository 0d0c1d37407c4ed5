#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace mrroc::core {

/// One value in memory, shared by one writer and any number of readers, threads or processes: a sequence lock over
/// atomic words (H.-J. Boehm, "Can seqlocks get along with programming language memory models?", MSPC 2012). The writer
/// is wait-free and independent of the readers; a reader retries while a write is under way and never reads a torn
/// value. No allocation, no system call. Zeroed memory is a valid empty slot.
template <class Value>
class SharedSlot {
  static_assert(std::is_trivially_copyable_v<Value>);

 public:
  /// Stores `value`. The one writer's thread.
  void store(const Value& value) noexcept {
    std::array<std::uint64_t, kWords> words{};
    std::memcpy(words.data(), &value, sizeof(Value));
    const std::uint64_t sequence = sequence_.load(std::memory_order_relaxed);
    sequence_.store(sequence + 1, std::memory_order_relaxed);
    // release on each word instead of one fence: the thread sanitizer does not support fences
    for (std::size_t i = 0; i < kWords; ++i) words_[i].store(words[i], std::memory_order_release);
    sequence_.store(sequence + 2, std::memory_order_release);
  }

  /// Copies the newest value; false when nothing has been stored, or when the writer died in the middle of a write. Any
  /// thread.
  bool load(Value& value) const noexcept {
    std::array<std::uint64_t, kWords> words;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const std::uint64_t before = sequence_.load(std::memory_order_acquire);
      if (before == 0) return false;
      if (before % 2 != 0) continue;
      for (std::size_t i = 0; i < kWords; ++i) words[i] = words_[i].load(std::memory_order_acquire);
      if (sequence_.load(std::memory_order_relaxed) == before) {
        std::memcpy(static_cast<void*>(&value), words.data(), sizeof(Value));
        return true;
      }
    }
    return false;
  }

  /// Twice the number of stores so far (odd while one is under way). Any thread.
  std::uint64_t sequence() const noexcept { return sequence_.load(std::memory_order_acquire); }

 private:
  static constexpr std::size_t kWords = (sizeof(Value) + 7) / 8;
  static constexpr int kAttempts = 1000000;
  std::atomic<std::uint64_t> sequence_{0};
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

}  // namespace mrroc::core
