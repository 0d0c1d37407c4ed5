#pragma once

/// Both directions: set-points, rad of the shafts; measured positions in the answer of the same number.
struct Packet {
  unsigned long long number;
  unsigned long long enabled;
  double position[8];
};
