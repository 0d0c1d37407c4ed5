#pragma once
#include <mrroc/message.hpp>

// What an arm can do. It has a bar by the end nearer to it; the tool frame is the middle of the bar.
struct Reach {  // up, over and down to (x, y, z) m in its base frame and `turn` rad, or until it touches something
  double x = 0, y = 0, z = 0, turn = 0;
};
MRROC_MESSAGE(Reach, x, y, z, turn)
struct Give {};  // waits until someone pulls at the bar
MRROC_MESSAGE(Give)
struct Take {};  // gives way to what the hand grips until end-motion, then pulls until end-motion
MRROC_MESSAGE(Take)

// What the belt can do.
struct Bring {};  // brings a bar and tells how the giver reaches it
MRROC_MESSAGE(Bring)
