#pragma once

#include <cstdint>
#include <cstdlib>
#include <new>

// For one source of a test program that is linked with --wrap=malloc,--wrap=calloc,--wrap=realloc.

// every way to the heap is counted: operator new here, malloc and its kin by the linker's --wrap
namespace {
thread_local bool counting = false;
thread_local std::uint64_t allocations = 0;
void count() {
  if (counting) ++allocations;
}
}  // namespace

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* old, std::size_t size);
void* __wrap_malloc(std::size_t size) {
  count();
  return __real_malloc(size);
}
void* __wrap_calloc(std::size_t number, std::size_t size) {
  count();
  return __real_calloc(number, size);
}
void* __wrap_realloc(void* old, std::size_t size) {
  count();
  return __real_realloc(old, size);
}
}

// not inlined: the compiler takes the pair malloc, delete for a mistake
[[gnu::noinline]] void* operator new(std::size_t size) {
  count();
  if (void* memory = __real_malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace mrroc::test {

/// Counts the allocations of this thread while it lives, into `allocations`.
class Counting {
 public:
  Counting() { allocations = 0, counting = true; }
  ~Counting() { counting = false; }
};

}  // namespace mrroc::test
