#pragma once

#include "vsp/configuration.hpp"

namespace mrroc::vsp {

/// Distances that a range sensor measures, m.
struct Range {
  double nearest = 0;
  double farthest = 0;
};

/// Throws NonFatalError(invalid_argument), naming configuration `label`, unless `wanted` is a range (nearest below
/// farthest) within that of the hardware.
inline void check_range(std::string_view label, const Range& wanted, const Range& hardware) {
  check_configured(label, "nearest", wanted.nearest, hardware.nearest, hardware.farthest, "m");
  check_configured(label, "farthest", wanted.farthest, hardware.nearest, hardware.farthest, "m");
  if (wanted.nearest >= wanted.farthest) refuse_configuration(label, "nearest", wanted.nearest, "less than farthest");
}

}  // namespace mrroc::vsp
