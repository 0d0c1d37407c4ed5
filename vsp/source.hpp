#pragma once

#include "vsp/raw_reading.hpp"

namespace mrroc::vsp {

/// What a source could give.
enum class SourceState {
  ready,      ///< `raw` is filled in
  not_ready,  ///< the hardware has not measured yet; it may later
  silent      ///< the hardware has stopped answering
};

/// Where raw data r comes from: simulated hardware, a played file, a driver. The VSP's thread; never waits for a
/// measurement, allocates nothing, never throws.
class Source {
 public:
  virtual ~Source() = default;
  /// The hardware reading of tick `wanted`, or the newest before it; `raw.tick` tells which.
  virtual SourceState read(Tick wanted, RawReading& raw) noexcept = 0;
};

}  // namespace mrroc::vsp
