#pragma once
struct Packet {  // set-points, rad of the shafts; in the answer of the same number the measured positions
  unsigned long long number, enabled;
  double position[8];
};
