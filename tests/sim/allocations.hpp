#pragma once

namespace mrroc::sim {

/// Allocations of this process so far: operator new and malloc of our own code, MuJoCo's mju_malloc once
/// `count_mujoco_allocations` has been called.
long allocations() noexcept;
void count_mujoco_allocations();

}  // namespace mrroc::sim
