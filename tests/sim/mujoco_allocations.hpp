#pragma once

#include <mujoco/mujoco.h>

#include <cstdlib>

#include "allocations.hpp"

namespace mrroc::test {

/// From now on `allocations` also counts MuJoCo's mju_malloc.
inline void count_mujoco_allocations() {
  mju_user_malloc = [](std::size_t size) {
    count_allocation();
    return std::aligned_alloc(64, (size + 63) / 64 * 64);
  };
  mju_user_free = std::free;
}

}  // namespace mrroc::test
