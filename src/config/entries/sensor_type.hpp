#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads the declarations of the sensor's type in sensors/<type>/<type>.toml of the share folder, and the type's own
/// keys of [sensors.NAME] into `sensor.numbers` and `sensor.texts`.
///
///     [[channels]]                         # of its readings; [[raw_channels]]: of the hardware's
///     name = "distance"
///     unit = "m"
///
///     sources = ["simulated", "hardware"]  # supported; left out: simulated, replay
///     effector_state = true                # its VSP needs the robot's state at every tick; left out: false
///     wrench = true                        # a robot's EDP may read it (vsp::WrenchSource); left out: false
///     effector_state_with = "tool_mass"    # or only where this parameter of the type's is not 0
///
/// The type's own keys are declared as declared_keys.hpp says. Throws ConfigurationError, which names the deployment
/// file for a wrong value and the type's file for a wrong declaration.
void read_sensor_type(const Table& table, SensorEntry& sensor);

}  // namespace mrroc::config
