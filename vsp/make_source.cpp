#include "vsp/make_source.hpp"

#include <cmath>

#include "vsp/driver.hpp"
#include "vsp/faulty_source.hpp"
#include "vsp/parameters.hpp"
#include "vsp/replay_source.hpp"
#include "vsp/simulated_source.hpp"

namespace mrroc::vsp {

namespace {

std::unique_ptr<Source> open_driver(const SourceContext& context) {
  const plugin::Interface& library = plugin::load(context.entry.driver->library, driver_interface(nullptr));
  std::unique_ptr<Source> source = reinterpret_cast<MakeSource>(library.make)(context);
  if (source == nullptr) refuse(context.entry, "source", "its driver opened nothing", "another source");
  return source;
}

std::unique_ptr<Source> make_true_source(VirtualSensor& sensor, const SourceContext& context) {
  const config::SensorEntry& entry = context.entry;
  if (auto own = sensor.open_source(context)) return own;
  if (entry.driver) return open_driver(context);
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
