#include "vsp/faulty_source.hpp"

#include <limits>

namespace mrroc::vsp {

SourceState FaultySource::read(Tick wanted, RawReading& raw) noexcept {
  SourceState state = source_->read(wanted, raw);
  for (const faults::FaultSwitch& each : faults_) {
    if (!each.on(wanted)) continue;
    switch (each.fault().kind) {
      case faults::Kind::silence:
        return SourceState::silent;
      case faults::Kind::jump:
        for (std::size_t i = 0; i < raw.count; ++i) raw.values[i] += each.fault().value;
        break;
      case faults::Kind::freeze: {
        const Tick tick = raw.tick;  // it keeps measuring the same value
        if (last_.count > 0) raw = last_;
        raw.tick = tick;
        break;
      }
      case faults::Kind::nan:
        for (std::size_t i = 0; i < raw.count; ++i) raw.values[i] = std::numeric_limits<double>::quiet_NaN();
        break;
      default:
        break;
    }
  }
  if (state == SourceState::ready) last_ = raw;
  return state;
}

}  // namespace mrroc::vsp
