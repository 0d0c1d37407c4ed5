#pragma once

#include <mrroc/message.hpp>

/// The behaviour of the machine's program: touch the board at columns x rows points, then carve the inscription.
struct Engrave {
  mrroc::FixedText<31> inscription;
  double height = 0.026;       // m, of a capital
  double depth = 0.001;        // m, below the surface
  int columns = 11, rows = 4;  // to the right, away from the reader
};
MRROC_MESSAGE(Engrave, inscription, height, depth, columns, rows)
