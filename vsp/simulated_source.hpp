#pragma once

#include "vsp/source.hpp"
#include "world/world_memory.hpp"

namespace mrroc::vsp {

/// The simulated hardware of one sensor: a slot of the world's memory, written by the sim process at every tick. In
/// lockstep the slot holds the present tick. In real time it may be some ticks behind or ahead: the newest reading is
/// returned, with its own tick; a reading more than `silent_after` ticks old counts as silent.
class SimulatedSource final : public Source {
 public:
  /// `slot`: index of the sensor in the deployment's list. Throws SystemError(configuration) when there is no such
  /// slot. `world` outlives the source.
  SimulatedSource(const world::WorldMemory& world, std::size_t slot, Tick silent_after);

  SourceState read(Tick wanted, RawReading& raw) noexcept override;

 private:
  const core::SharedSlot<RawReading>* slot_;
  Tick silent_after_;
  RawReading newest_{};
  bool there_ = false;  ///< `newest_` is valid
};

}  // namespace mrroc::vsp
