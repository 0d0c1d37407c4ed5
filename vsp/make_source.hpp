#pragma once

#include <memory>

#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Simulated hardware that has not measured for this long, s, is silent. The world itself gives up when it is
/// kPatienceWithWorld behind.
inline constexpr double kSilentAfter = 1.5 * world::kPatienceWithWorld;

/// The source that the deployment asks for: the sensor type's own, else a played file or a slot of the simulated world.
/// Throws what `open_source` throws, ConfigurationError for a played file that is wrong, SystemError(configuration)
/// when a simulated sensor has no world or the type has no hardware.
std::unique_ptr<Source> make_source(VirtualSensor& sensor, const SourceContext& context);

}  // namespace mrroc::vsp
