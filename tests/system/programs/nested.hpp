#pragma once

#include "mrroc/message.hpp"

namespace mrroc::test {

/// A behaviour: the belt runs, and after 20 steps its generator throws. `where` it is caught: 0 at the Move, 1 around
/// several Moves of the behaviour, 2 not in the ECP.
struct Fail {
  int where = 0;
};
MRROC_MESSAGE(Fail, where)

/// From the ECP: an error that it has caught, and the distance that the belt moved after it had come to rest, m.
struct Caught {
  FixedText<31> where;
  std::uint64_t step = 0;
  Tick tick = 0;
  double moved = 0;
};
MRROC_MESSAGE(Caught, where, step, tick, moved)

}  // namespace mrroc::test
