#pragma once

#include "clock/clock.hpp"

namespace mrroc::clock {

/// Takes no further part in the deployment's time: no process waits for this one, however long it takes to end. Every
/// later wait returns `interrupted`. The participant's thread.
inline void leave(Clock& clock) {
  clock.interrupt();
  clock.wait(kNever);
}

}  // namespace mrroc::clock
