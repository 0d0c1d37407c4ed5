#pragma once

#include <memory>

#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Simulated hardware that has not measured for this long, s, is silent. The world itself ends with an error when it is
/// kPatienceWithWorld behind.
inline constexpr double kSilentAfter = 1.5 * world::kPatienceWithWorld;

/// The source that the deployment names: the sensor type's own, else its driver's, a played file, or a slot of the
/// simulated world.
/// Throws the exceptions of `open_source`, ConfigurationError for an invalid played file, SystemError(configuration)
/// when a simulated sensor has no world or the type has no hardware,
/// and those of `plugin::load` and of the driver.
std::unique_ptr<Source> make_source(VirtualSensor& sensor, const SourceContext& context);

}  // namespace mrroc::vsp
