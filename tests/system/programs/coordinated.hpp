#pragma once

#include "mrroc/message.hpp"

namespace mrroc::test {

/// A behaviour: takes part in Moves of the MP and commands what the MP does.
struct Mirror {
  std::uint32_t ends_after = 0;    ///< steps; 0: with the MP's Move
  std::uint32_t throws_after = 0;  ///< steps; 0: never
  bool stays = false;              ///< in the MP's following Moves, until `end_motion`
  bool refused = false;            ///< commands what the EDP refuses, at its fifth step
};
MRROC_MESSAGE(Mirror, ends_after, throws_after, stays, refused)

/// A behaviour: takes part, and corrects the MP's path by `height` m along the tool's z axis.
struct Correct {
  double height = 0;
};
MRROC_MESSAGE(Correct, height)

/// A behaviour: takes part, and gives way to the wrench that its force sensor measures.
struct Comply {};
MRROC_MESSAGE(Comply)

/// A behaviour: takes part, and weaves about the MP's path.
struct Weave {};
MRROC_MESSAGE(Weave)

/// A behaviour: takes no part, and holds for `steps`.
struct Rest {
  std::uint32_t steps = 0;
};
MRROC_MESSAGE(Rest, steps)

/// From the ECP, when its Move has ended.
struct Took {
  std::uint64_t steps = 0;
  std::uint64_t plans = 0;  ///< starts and resumptions of its generator
  bool ended = false;       ///< superior().ended()
};
MRROC_MESSAGE(Took, steps, plans, ended)

}  // namespace mrroc::test
