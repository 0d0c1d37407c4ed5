#pragma once

#include <memory>

#include "plugin/plugin.hpp"
#include "vsp/source.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Opens the hardware of one sensor: `context.entry.driver` holds the driver's own keys, checked against
/// drivers/NAME/NAME.toml. The source gives the raw channels of the sensor's type. Main thread of the VSP, and of an
/// EDP whose robot has the sensor. Throws ConfigurationError, SystemError(configuration) or HardwareError. Never null.
using MakeSource = std::unique_ptr<Source> (*)(const SourceContext& context);

/// Version of `Source` and SourceContext. A driver of another version is refused when it is loaded.
inline constexpr std::uint32_t kDriverVersion = 1;

/// The interface of a sensor driver whose factory is `make`.
inline plugin::Interface driver_interface(MakeSource make) noexcept {
  return {"sensor driver", kDriverVersion,
          plugin::layout_of(
              {sizeof(RawReading), sizeof(SourceContext), sizeof(config::SensorEntry), sizeof(config::Deployment)}),
          reinterpret_cast<void (*)()>(make)};
}

}  // namespace mrroc::vsp

/// Makes a driver of a function `std::unique_ptr<mrroc::vsp::Source> make(const mrroc::vsp::SourceContext&)`. Once, in
/// a source of `mrroc_add_driver`.
#define MRROC_SENSOR_DRIVER(make) MRROC_PLUGIN(mrroc::vsp::driver_interface(make))
