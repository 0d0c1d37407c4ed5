#include "vsp/make_source.hpp"

#include <cmath>

#include "mrroc/errors.hpp"
#include "vsp/replay_source.hpp"
#include "vsp/simulated_source.hpp"

namespace mrroc::vsp {

std::unique_ptr<Source> make_source(const config::SensorEntry& entry, const VirtualSensor& sensor,
                                    const sim::WorldMemory* world, std::size_t slot, double servo_period) {
  if (entry.source == "replay") return std::make_unique<ReplaySource>(entry.replay, sensor.raw_channels());
  if (world == nullptr) {
    throw SystemError(
        ErrorCode::configuration,
        "sensors." + entry.name + ".source: 'simulated' without a simulated world, expected a [sim] table",
        {"", entry.name, 0, 0});
  }
  return std::make_unique<SimulatedSource>(*world, slot, static_cast<Tick>(std::ceil(kSilentAfter / servo_period)));
}

}  // namespace mrroc::vsp
