#pragma once

#include <cstdint>

namespace mrroc::driver_test {

/// What the calling thread has done so far that a servo tick may not do. Libraries that are loaded at run time count,
/// too: the program exports its own malloc and pthread_mutex_lock to them.
struct Counts {
  std::uint64_t allocations = 0;  ///< malloc, calloc, realloc, operator new
  std::uint64_t locks = 0;        ///< mutexes, read-write locks
  std::uint64_t sleeps = 0;       ///< voluntary switches to another thread

  Counts operator-(const Counts& before) const {
    return {allocations - before.allocations, locks - before.locks, sleeps - before.sleeps};
  }
};

Counts counts() noexcept;

/// False under a sanitizer, which has its own malloc.
bool counts_allocations() noexcept;

}  // namespace mrroc::driver_test
