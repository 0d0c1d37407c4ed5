#include "allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> of_process{0};
thread_local std::uint64_t of_thread = 0;
std::atomic<std::uint64_t> freed{0};

}  // namespace

namespace mrroc::test {

std::uint64_t allocations() noexcept { return of_process.load(); }
std::uint64_t thread_allocations() noexcept { return of_thread; }
std::uint64_t frees() noexcept { return freed.load(); }
void count_allocation() noexcept {
  of_process.fetch_add(1);
  ++of_thread;
}

}  // namespace mrroc::test

// the linker's --wrap redirects malloc, calloc and realloc here
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);
void* __wrap_malloc(std::size_t size) {
  mrroc::test::count_allocation();
  return __real_malloc(size);
}
void* __wrap_calloc(std::size_t count, std::size_t size) {
  mrroc::test::count_allocation();
  return __real_calloc(count, size);
}
void* __wrap_realloc(void* memory, std::size_t size) {
  mrroc::test::count_allocation();
  return __real_realloc(memory, size);
}
}

namespace {

void* counted(std::size_t size) noexcept {
  mrroc::test::count_allocation();
  return __real_malloc(size);
}

void* counted_or_throw(std::size_t size) {
  if (void* memory = counted(size)) return memory;
  throw std::bad_alloc();
}

void* aligned(std::size_t size, std::align_val_t alignment) {
  mrroc::test::count_allocation();
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}

void release(void* memory) noexcept {
  if (memory != nullptr) freed.fetch_add(1, std::memory_order_relaxed);
  std::free(memory);
}

}  // namespace

// all forms: a sanitizer's would not be counted, and do not match this delete
// noinline: GCC warns about a visible pair of malloc and delete
[[gnu::noinline]] void* operator new(std::size_t size) { return counted_or_throw(size); }
[[gnu::noinline]] void* operator new[](std::size_t size) { return counted_or_throw(size); }
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept { return counted(size); }
[[gnu::noinline]] void* operator new[](std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  return counted(size);
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) { return aligned(size, alignment); }
[[gnu::noinline]] void* operator new[](std::size_t size, std::align_val_t alignment) {
  return aligned(size, alignment);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { release(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::align_val_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
