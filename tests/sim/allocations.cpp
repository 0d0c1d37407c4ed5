#include "allocations.hpp"

#include <mujoco/mujoco.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> count{0};

void* mujoco_malloc(std::size_t size) {
  ++count;
  return std::aligned_alloc(64, (size + 63) / 64 * 64);
}

}  // namespace

// the linker sends every malloc of our own object files here (--wrap), Eigen's included
extern "C" void* __real_malloc(std::size_t size);
extern "C" void* __wrap_malloc(std::size_t size);
void* __wrap_malloc(std::size_t size) {
  ++count;
  return __real_malloc(size);
}

// not inlined: the compiler takes the pair malloc, delete for a mistake
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace mrroc::sim {

long allocations() noexcept { return count; }

void count_mujoco_allocations() {
  mju_user_malloc = mujoco_malloc;
  mju_user_free = std::free;
}

}  // namespace mrroc::sim
