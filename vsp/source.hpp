#pragma once

#include <string_view>

#include "vsp/raw_reading.hpp"

namespace mrroc::vsp {

/// The result of reading a source.
enum class SourceState {
  ready,      ///< `raw` is filled in
  not_ready,  ///< the hardware has not measured yet
  silent,     ///< the hardware has stopped answering
  faulty      ///< the hardware answers, but reports that its measurements are invalid: `fault()`
};

/// The source of raw data r: simulated hardware, a played file, a driver. The VSP's thread; allocates nothing, never
/// throws. In real time it never waits for a measurement; in lockstep a stand-in is awaited for that of the tick.
class Source {
 public:
  virtual ~Source() = default;
  /// The hardware reading of tick `wanted`, or the newest before it; `raw.tick` is its tick.
  virtual SourceState read(Tick wanted, RawReading& raw) noexcept = 0;
  /// Why the last `read` returned `faulty`: a sentence whose subject is the hardware, without a full stop. Valid until
  /// the next `read`.
  virtual std::string_view fault() const noexcept { return {}; }
};

}  // namespace mrroc::vsp
