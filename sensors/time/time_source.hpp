#pragma once

#include "vsp/source.hpp"

namespace mrroc::vsp {

/// The clock as hardware: the reading of a tick is its number, and there is one at every tick. It does not read a
/// clock: the requested tick is the time.
class TimeSource final : public Source {
 public:
  SourceState read(Tick wanted, RawReading& raw) noexcept override;
};

}  // namespace mrroc::vsp
