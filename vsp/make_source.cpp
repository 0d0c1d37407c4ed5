#include "vsp/make_source.hpp"

#include <cmath>

#include "vsp/parameters.hpp"
#include "vsp/replay_source.hpp"
#include "vsp/simulated_source.hpp"

namespace mrroc::vsp {

std::unique_ptr<Source> make_source(VirtualSensor& sensor, const SourceContext& context) {
  const config::SensorEntry& entry = context.entry;
  if (auto own = sensor.open_source(context)) return own;
  if (entry.source == "replay") return std::make_unique<ReplaySource>(entry.replay, sensor.raw_channels());
  if (entry.source == "hardware") refuse(entry, "source", "its type opens no hardware", "another source");
  if (context.world == nullptr) refuse(entry, "source", "'simulated' without a simulated world", "a table [sim]");
  return std::make_unique<SimulatedSource>(*context.world, context.slot,
                                           static_cast<Tick>(std::ceil(kSilentAfter / context.servo_period)));
}

}  // namespace mrroc::vsp
