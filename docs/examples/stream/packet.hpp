#pragma once
struct Packet {  // of a tick: set-points, rad of the shafts; in the answer of the same tick the measured positions
  unsigned long long tick, enabled;
  double position[8];
};
