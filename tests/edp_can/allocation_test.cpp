#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <new>

#include "can_rig.hpp"

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

namespace mrroc::edp {
namespace {

class Counting {
 public:
  Counting() { allocations = 0, counting = true; }
  ~Counting() { counting = false; }
};

TEST(Allocation, TheCounterSeesBothWays) {
  void* (*volatile allocate)(std::size_t) = std::malloc;  // volatile: or the compiler drops the pairs
  void* (*volatile make)(std::size_t) = ::operator new;
  {
    const Counting scope;
    std::free(allocate(10));
  }
  EXPECT_EQ(allocations, 1u);
  {
    const Counting scope;
    ::operator delete(make(10));
  }
  EXPECT_EQ(allocations, 1u);
}

/// All that the servo's thread does with the drives: motion, a drive that restarts and is set up anew, a stop.
TEST(Allocation, TheCyclicPathAllocatesNothing) {
  CanRig<Gantry> rig(canopen::DriveMode::cyclic_position);
  rig.replies.reserve(100);
  ASSERT_TRUE(rig.seen().enabled);
  const RobotCommand motion = relative_joints(JointVector::Constant(4, 0.2), 400);
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  {
    const Counting scope;
    rig.send(motion);
    rig.run(200);
  }
  EXPECT_EQ(allocations, 0u);
  rig.rack.with([](auto& nodes) { nodes[1].boot(0); });
  {
    const Counting scope;
    rig.run(300);
    rig.send(recover);
    rig.run(400);
  }
  EXPECT_EQ(allocations, 0u);
  EXPECT_TRUE(rig.seen().enabled) << describe(rig.seen().fault.code);
  {
    const Counting scope;
    rig.effector.enable(false);
    rig.run(200);
  }
  EXPECT_EQ(allocations, 0u);
}

}  // namespace
}  // namespace mrroc::edp
