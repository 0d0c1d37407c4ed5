#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace mrroc::core {

/// A sequence lock over atomic words (H.-J. Boehm, "Can seqlocks get along with programming language memory models?",
/// MSPC 2012), for one writer and any number of readers, threads or processes. Zeroed memory is valid and empty.
using SequencedWords = std::span<std::atomic<std::uint64_t>>;

/// Stores `values`, as many as `words`. Wait-free, independent of the readers. The one writer's thread.
inline void store_words(std::atomic<std::uint64_t>& sequence, SequencedWords words,
                        const std::uint64_t* values) noexcept {
  const std::uint64_t before = sequence.load(std::memory_order_relaxed);
  sequence.store(before + 1, std::memory_order_relaxed);
  // release on each word instead of one fence: the thread sanitizer does not support fences
  for (std::size_t i = 0; i < words.size(); ++i) words[i].store(values[i], std::memory_order_release);
  sequence.store(before + 2, std::memory_order_release);
}

/// Copies what was stored last, retrying while a write is under way: never a torn value. False when nothing has been
/// stored, or when the writer died in the middle of a write. Any thread.
inline bool load_words(const std::atomic<std::uint64_t>& sequence, std::span<const std::atomic<std::uint64_t>> words,
                       std::uint64_t* values) noexcept {
  constexpr int kAttempts = 1000000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const std::uint64_t before = sequence.load(std::memory_order_acquire);
    if (before == 0) return false;
    if (before % 2 != 0) continue;
    for (std::size_t i = 0; i < words.size(); ++i) values[i] = words[i].load(std::memory_order_acquire);
    if (sequence.load(std::memory_order_relaxed) == before) return true;
  }
  return false;
}

}  // namespace mrroc::core
