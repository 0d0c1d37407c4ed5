#pragma once

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <string>
#include <type_traits>
#include <utility>

#include "core/shared_memory.hpp"

namespace mrroc::core {

/// First-in-first-out queue from one thread of a process to one thread of the process that started it, in memory that
/// both map: without a lock, all entries allocated at once. An entry that finds no room is dropped and counted, or
/// waits for room. Entries are plain values; a reader must not trust what a damaged writer puts into them.
template <class Entry, std::size_t kEntries>
class SharedRing {
  static_assert(std::is_trivially_copyable_v<Entry>);

 public:
  static constexpr std::size_t kCapacity = kEntries;

  /// Empty. `name` is that of the kernel's lists, `what` that of messages. Throws SystemError(resources) without
  /// memory.
  static SharedRing create(const char* name, const std::string& what) {
    SharedRing ring(SharedMemory::create(name, sizeof(Memory), what));
    ring.memory_->reader = getpid();
    return ring;
  }
  /// Throws SystemError(resources) when `fd` is not such a memory. The descriptor stays the caller's.
  static SharedRing attach(int fd, const std::string& what) {
    return SharedRing(SharedMemory::attach(fd, sizeof(Memory), what));
  }

  /// Descriptor of a memory that was created here, for a child; -1 otherwise. Closed with this object.
  int fd() const noexcept { return mapped_.fd(); }

  /// Where the next entry is to be written, with what the last one there has left; null: no room, it is dropped.
  /// `publish` makes it the newest. `waits`: sleeps until there is room, as long as the reader's process lives. The
  /// writer's thread; does not allocate.
  Entry* claim(bool waits) noexcept {
    while (waits && full() && reader_lives()) {
      const timespec pause{0, kSleep};
      nanosleep(&pause, nullptr);
    }
    if (full()) {
      memory_->dropped.fetch_add(1, std::memory_order_relaxed);
      return nullptr;
    }
    return &memory_->entries[memory_->added.load(std::memory_order_relaxed) % kEntries];
  }
  /// The writer's thread.
  void publish() noexcept { memory_->added.fetch_add(1, std::memory_order_release); }
  /// No further entry will come. The writer's thread.
  void end() noexcept { memory_->ended.store(1, std::memory_order_release); }

  /// Bytes of memory of each.
  static constexpr std::size_t memory_size() noexcept { return sizeof(Memory); }
  /// The oldest entry, valid until `pop`; null: the ring is empty, or its writer has damaged its memory. The reader's
  /// thread.
  const Entry* front() const noexcept {
    const std::uint64_t taken = memory_->taken.load(std::memory_order_relaxed);
    const std::uint64_t waiting = memory_->added.load(std::memory_order_acquire) - taken;
    if (waiting == 0 || waiting > kEntries) return nullptr;
    return &memory_->entries[taken % kEntries];
  }
  /// Removes the oldest entry; there must be one. The reader's thread.
  void pop() noexcept { memory_->taken.fetch_add(1, std::memory_order_release); }

  /// Whether the writer has ended in order: it was not killed. Any thread.
  bool ended() const noexcept { return memory_->ended.load(std::memory_order_acquire) != 0; }
  /// Entries that were added, and those that were dropped. Any thread.
  std::uint64_t added() const noexcept { return memory_->added.load(std::memory_order_acquire); }
  std::uint64_t dropped() const noexcept { return memory_->dropped.load(std::memory_order_relaxed); }

 private:
  static constexpr long kSleep = 100'000;  // ns between two checks for room

  /// All zero but for the reader, as the kernel provides it, is an empty one.
  struct Memory {
    std::atomic<std::uint64_t> added;  ///< by the writer, as all but `taken`
    std::atomic<std::uint64_t> dropped;
    std::atomic<std::uint64_t> ended;
    pid_t reader;                                  ///< by the reader, before there is a writer
    alignas(64) std::atomic<std::uint64_t> taken;  ///< by the reader
    alignas(64) std::array<Entry, kEntries> entries;
  };
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

  explicit SharedRing(SharedMemory mapped) noexcept
      : mapped_(std::move(mapped)), memory_(static_cast<Memory*>(mapped_.address())) {}

  bool full() const noexcept {
    return memory_->added.load(std::memory_order_relaxed) - memory_->taken.load(std::memory_order_acquire) >= kEntries;
  }

  /// By either sign: a program may be started by a script, and a process that died remains until it is waited for.
  bool reader_lives() const noexcept {
    return getppid() == parent_ && (kill(memory_->reader, 0) == 0 || errno != ESRCH);
  }

  SharedMemory mapped_;
  Memory* memory_;
  pid_t parent_ = getppid();
};

}  // namespace mrroc::core
