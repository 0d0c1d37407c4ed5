#pragma once

#include "mrroc/message.hpp"

namespace mrroc::test {

/// A behaviour: the arm takes part in the transfer of a bar, and gives way to what it feels beside its share of the
/// bar's weight.
struct Share {
  double mass = 0;  ///< of the bar, kg
};
MRROC_MESSAGE(Share, mass)

}  // namespace mrroc::test
