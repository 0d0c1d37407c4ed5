#include "vsp/simulated_source.hpp"

#include <algorithm>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::vsp {

static_assert(kMaxRawValues >= sim::kMaxHardwareValues);

SimulatedSource::SimulatedSource(const sim::WorldMemory& world, std::size_t slot, Tick silent_after)
    : slot_(slot < sim::kMaxSensors ? &world.readings[slot] : nullptr), silent_after_(silent_after) {
  if (slot_ == nullptr) {
    throw SystemError(ErrorCode::configuration, "sensor slot " + std::to_string(slot) + " of the simulated world, " +
                                                    "expected at most " + std::to_string(sim::kMaxSensors - 1));
  }
}

SourceState SimulatedSource::read(Tick wanted, RawReading& raw) noexcept {
  sim::HardwareReading reading;
  const bool there = slot_->load(reading);
  if (there) newest_ = reading.tick;
  if (wanted > newest_ && wanted - newest_ > silent_after_) return SourceState::silent;
  if (!there) return SourceState::not_ready;
  raw.tick = reading.tick;
  raw.count = std::min(reading.count, static_cast<std::uint32_t>(sim::kMaxHardwareValues));
  std::copy_n(reading.values.begin(), raw.count, raw.values.begin());
  return SourceState::ready;
}

}  // namespace mrroc::vsp
