#pragma once

#include "mrroc/message.hpp"

namespace mrroc::test {

/// A behaviour: the belt moves to `position` m at a part of its speed.
struct Go {
  double position = 0;
  double speed = 0.9;
};
MRROC_MESSAGE(Go, position, speed)

/// A behaviour: the belt runs at `speed` m/s until a message changes it.
struct Run {
  double speed = 0;
};
MRROC_MESSAGE(Run, speed)

/// A behaviour: asks the operator for the target position.
struct Ask {};
MRROC_MESSAGE(Ask)

/// From the ECP: the position that it has reached.
struct Arrived {
  double position = 0;
  Tick tick = 0;
  FixedText<15> by;
};
MRROC_MESSAGE(Arrived, position, tick, by)

/// To the ECP: the speed from now on.
struct Faster {
  double speed = 0;
};
MRROC_MESSAGE(Faster, speed)

/// A message without a behaviour in any ECP.
struct Fly {};
MRROC_MESSAGE(Fly)

}  // namespace mrroc::test
