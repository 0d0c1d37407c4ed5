#pragma once

#include <cstdint>

namespace mrroc::test {

/// Allocations so far by operator new, in all its forms, and by malloc, calloc and realloc of the objects that are
/// linked statically (Eigen's included). Tests link `allocation_count`. Any thread.
std::uint64_t allocations() noexcept;         ///< of this process
std::uint64_t thread_allocations() noexcept;  ///< of the calling thread
/// Memory of operator new that this process has given back so far. Any thread.
std::uint64_t frees() noexcept;

/// Counts one allocation of another allocator.
void count_allocation() noexcept;

/// Counts the allocations of the calling thread during its lifetime.
class Counting {
 public:
  Counting() noexcept : before_(thread_allocations()) {}
  ~Counting() { counted() = thread_allocations() - before_; }
  Counting(const Counting&) = delete;
  Counting& operator=(const Counting&) = delete;

  /// The number that the last counter has counted.
  static std::uint64_t& counted() noexcept {
    thread_local std::uint64_t count = 0;
    return count;
  }

 private:
  std::uint64_t before_;
};

}  // namespace mrroc::test
