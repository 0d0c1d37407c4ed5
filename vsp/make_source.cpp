#include "vsp/make_source.hpp"

#include <cmath>

#include "vsp/faulty_source.hpp"
#include "vsp/parameters.hpp"
#include "vsp/replay_source.hpp"
#include "vsp/simulated_source.hpp"

namespace mrroc::vsp {

namespace {

std::unique_ptr<Source> make_true_source(VirtualSensor& sensor, const SourceContext& context) {
  const config::SensorEntry& entry = context.entry;
  if (auto own = sensor.open_source(context)) return own;
  if (entry.source == "replay") return std::make_unique<ReplaySource>(entry.replay, sensor.raw_channels());
  if (entry.source == "hardware") refuse(entry, "source", "its type opens no hardware", "another source");
  if (context.world == nullptr) refuse(entry, "source", "'simulated' without a simulated world", "a table [sim]");
  return std::make_unique<SimulatedSource>(*context.world, context.slot,
                                           static_cast<Tick>(std::ceil(kSilentAfter / context.servo_period)));
}

}  // namespace

std::unique_ptr<Source> make_source(VirtualSensor& sensor, const SourceContext& context) {
  auto source = make_true_source(sensor, context);
  if (context.faults.empty()) return source;
  return std::make_unique<FaultySource>(std::move(source), context.faults);
}

}  // namespace mrroc::vsp
