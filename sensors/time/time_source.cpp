#include "sensors/time/time_source.hpp"

namespace mrroc::vsp {

SourceState TimeSource::read(Tick wanted, RawReading& raw) noexcept {
  raw.tick = wanted;
  raw.count = 1;
  raw.values[0] = static_cast<double>(wanted);
  return SourceState::ready;
}

}  // namespace mrroc::vsp
