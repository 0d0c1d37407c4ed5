#pragma once

#include <memory>

#include "config/deployment.hpp"
#include "edp/hardware.hpp"
#include "mrroc/robot_model.hpp"
#include "plugin/plugin.hpp"
#include "world/world_memory.hpp"

namespace mrroc::edp {

/// The objects from which a driver makes the drives of one robot; all outlive it.
struct DriverContext {
  /// Its entry in the deployment; `robot.driver` holds the driver's own keys, checked against drivers/NAME/NAME.toml.
  const config::RobotEntry& robot;
  const RobotModel& model;    ///< the nominal one: kinematics and parameters
  double servo_period;        ///< s
  bool simulated_time;        ///< lockstep: ticks follow the clock of the deployment, not the wall's
  world::WorldMemory* world;  ///< the simulated world of a driver that declares `world = true`; else null
  std::size_t slot;           ///< of the robot in it: its index in the deployment
};

/// Makes the drives, without opening them (`Hardware::open`). Main thread of the EDP. Throws SystemError(configuration)
/// for keys that contradict each other or the robot. Never null.
using MakeHardware = std::unique_ptr<Hardware> (*)(const DriverContext& context);

/// Version of `Hardware` and DriverContext. A driver of another version is refused when it is loaded.
inline constexpr std::uint32_t kDriverVersion = 3;

/// The interface of a robot driver whose factory is `make`.
inline plugin::Interface driver_interface(MakeHardware make) noexcept {
  return {
      "robot driver", kDriverVersion,
      plugin::layout_of({sizeof(HardwareInput), sizeof(BeatCounters), sizeof(DriverContext), sizeof(config::RobotEntry),
                         sizeof(RobotParameters), sizeof(AxisParameters), sizeof(world::WorldMemory), kMaxJoints}),
      reinterpret_cast<void (*)()>(make)};
}

}  // namespace mrroc::edp

/// Makes a driver of a function `std::unique_ptr<mrroc::edp::Hardware> make(const mrroc::edp::DriverContext&)`. Once,
/// in a source of `mrroc_add_driver`.
#define MRROC_DRIVER(make) MRROC_PLUGIN(mrroc::edp::driver_interface(make))
