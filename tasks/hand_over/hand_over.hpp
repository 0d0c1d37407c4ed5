#pragma once
#include <mrroc/message.hpp>

// Behaviours of an arm. It holds a bar at the nearer end; the tool frame is the middle of the bar.
struct Reach {  // up, over and down to (x, y, z) m in its base frame and `turn` rad, or until it touches something
  double x = 0, y = 0, z = 0, turn = 0;
};
MRROC_MESSAGE(Reach, x, y, z, turn)
struct Give {};  // waits until the bar is pulled
MRROC_MESSAGE(Give)
struct Take {};  // complies with the gripped bar until end-motion, then pulls until end-motion
MRROC_MESSAGE(Take)

// Behaviours of the belt.
struct Bring {};  // brings a bar and sends the giver's path to it
MRROC_MESSAGE(Bring)
