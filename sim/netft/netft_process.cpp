#include "sim/netft/netft_process.hpp"

#include <utility>

#include "clock/wall/monotonic.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/stopped.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::sim {

namespace {

constexpr Tick kGlanceTicks = 50;  // without a new state of the world, after which it counts as ended

RawReading newest_of(const world::WorldMemory& world, std::size_t slot) {
  RawReading reading;
  world.readings[slot].load(reading);
  return reading;
}

/// Waits for the world: without it there is no load to measure.
void await_world(const clock::Clock& clock, world::WorldMemory& world, std::size_t slot) {
  RawReading reading;
  const auto there = [&] { return world.readings[slot].load(reading); };
  constexpr std::int64_t kSlice = clock::kSecond / 10;  // between two checks for the end
  while (!clock.stopping() && !world.measured.wait(there, kSlice)) {
  }
}

}  // namespace

NetftLoad load_of_world(const world::WorldMemory& world, std::size_t slot) {
  return [readings = &world.readings.at(slot)](double /*time*/) {
    RawReading reading;
    Wrench load = Wrench::Zero();
    if (readings->load(reading) && reading.count >= 6) load = -Eigen::Map<const Wrench>(reading.values.data());
    return load;
  };
}

std::size_t sensor_of_process(const config::Deployment& deployment, const std::string& name) {
  for (std::size_t i = 0; i < deployment.sensors.size(); ++i) {
    const config::SensorEntry& sensor = deployment.sensors[i];
    if (sensor.driver && name == sensor.stand_in_process()) return i;
  }
  throw SystemError(ErrorCode::simulator, "the deployment has no sensor for the process " + name);
}

void serve_netft(process::Process& process, NetftSettings settings) {
  const std::size_t slot = sensor_of_process(process.deployment(), process.name());
  const world::MappedWorld world = world::MappedWorld::attach(process.arguments().world_fd);
  clock::Clock& clock = process.clock();
  await_world(clock, *world, slot);
  if (clock.simulated())
    settings.now = [&world = *world, slot, period = clock.period()] {
      return netft::to_ns(static_cast<double>(newest_of(world, slot).tick) * period);
    };
  NetftServer server(settings, load_of_world(*world, slot));
  process.start();
  RawReading reading;
  while (clock.wait(clock.tick() + kGlanceTicks) != clock::Wake::interrupted) {
    const Tick measured = std::exchange(reading, newest_of(*world, slot)).tick;
    // the world ends when no robot is driven any more: until then an EDP may need its sensor
    if (clock.stopping() && reading.tick == measured) break;
    links::Counters counters;
    counters.ticks = reading.tick;
    process.status().counters(counters);
  }
  throw Stopped{};
}

}  // namespace mrroc::sim
