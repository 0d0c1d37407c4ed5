#include "vsp/simulated_source.hpp"

#include <algorithm>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::vsp {

SimulatedSource::SimulatedSource(const world::WorldMemory& world, std::size_t slot, Tick silent_after)
    : slot_(slot < world::kMaxSensors ? &world.readings[slot] : nullptr), silent_after_(silent_after) {
  if (slot_ == nullptr) {
    throw SystemError(ErrorCode::configuration, "sensor slot " + std::to_string(slot) + " of the simulated world, " +
                                                    "expected at most " + std::to_string(world::kMaxSensors - 1));
  }
}

SourceState SimulatedSource::read(Tick wanted, RawReading& raw) noexcept {
  there_ = slot_->load(newest_) || there_;  // during a write the previous reading stays
  if (wanted > newest_.tick && wanted - newest_.tick > silent_after_) return SourceState::silent;
  if (!there_) return SourceState::not_ready;
  raw = newest_;
  raw.count = std::min(raw.count, std::uint32_t{kMaxRawValues});
  return SourceState::ready;
}

}  // namespace mrroc::vsp
