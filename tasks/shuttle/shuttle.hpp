#pragma once

#include <mrroc/message.hpp>

/// A behaviour: the belt moves to `position` m at a part (0..1) of its greatest speed.
struct Go {
  double position = 0;
  double speed = 0.9;
};
MRROC_MESSAGE(Go, position, speed)

/// A behaviour: the belt runs until `position` m, and reports when it is half-way.
struct Bring {
  double position = 0;
};
MRROC_MESSAGE(Bring, position)

/// The message of a belt to the MP.
struct HalfWay {
  double position = 0;  // m
};
MRROC_MESSAGE(HalfWay, position)
