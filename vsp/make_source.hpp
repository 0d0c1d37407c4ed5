#pragma once

#include <memory>

#include "config/deployment.hpp"
#include "sim/world_memory.hpp"
#include "vsp/source.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Simulated hardware that has not measured for this long, s, is silent. The world itself gives up when it is
/// kPatienceWithWorld behind.
inline constexpr double kSilentAfter = 1.5 * sim::kPatienceWithWorld;

/// The source that `entry` asks for: `replay` or `simulated`. `slot`: the sensor's index in the deployment; `world`:
/// the simulated hardware, null when there is none. Throws ConfigurationError for a played file that is wrong,
/// SystemError(configuration) when a simulated sensor has no world.
std::unique_ptr<Source> make_source(const config::SensorEntry& entry, const VirtualSensor& sensor,
                                    const sim::WorldMemory* world, std::size_t slot, double servo_period);

}  // namespace mrroc::vsp
