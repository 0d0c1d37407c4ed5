#pragma once

#include "core/shared_ring.hpp"
#include "edp/servo/servo_sample.hpp"

namespace mrroc::edp {

/// Carries a sample of every tick of one servo to the runner, which records them: 8 s at 500 Hz fit in. Under the real
/// clock the servo does not wait for a runner that is too slow, or hangs: the newest samples are dropped and counted.
using ServoTap = core::SharedRing<ServoSample, 4096>;

/// As which the kernel lists its memory, and its name in messages.
inline constexpr const char* kServoTapName = "mrroc-servo";
inline constexpr const char* kServoTapWhat = "memory of recorded servo ticks";

}  // namespace mrroc::edp
