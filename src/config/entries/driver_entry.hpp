#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads the driver that `key` of a robot's table (`hardware`) or a sensor's (`source`) names, with its own keys in the
/// sub-table of its name. The driver declares in drivers/NAME/NAME.toml of the share folder:
///
///     of = "robot"             # robot | sensor
///     types = ["force_torque"] # of a sensor: the types for which it measures
///     world = true             # its device is part of the simulated world; left out: false
///     clocks = ["real"]        # the clocks under which it works; left out: every clock
///     stand_in = "PROGRAM"     # simulates its device in the simulated world, with the key `simulated = true`: under
///     stand_in_clocks = [...]  # these clocks; left out: every clock. `{type}` is the robot's type
///     table = "can"            # name of the sub-table; left out: NAME
///     controller = "ur"        # of a sensor that the controller of robots with this driver contains
///
/// and its own keys as declared_keys.hpp says. `device` is the name of the robot or sensor, `type` its type, `host` its
/// host. Throws ConfigurationError also for keys of a driver that is not this one, a driver that needs the simulated
/// world without a [sim], another clock, and on the device's own host for a missing library or stand-in.
///
/// A sensor inside a controller has the controller's name in `source` and as its sub-table, instead of NAME:
/// `join_controller`. Where the controller is simulated, it works under `stand_in_clocks`.
DriverEntry read_driver(const Table& table, std::string_view key, const std::string& device, const std::string& type,
                        const std::string& host, const Deployment& deployment);

/// Throws ConfigurationError for the sub-table of a driver of robots (sensors) that is not `name`, the value of `key`.
void refuse_driver_tables(const Table& table, std::string_view key, const std::string& name, std::string_view of);

/// Marks the sub-tables of these drivers of robots ("robot") or sensors ("sensor") as used, so that `read_driver`
/// judges them.
void allow_driver_tables(const Table& table, std::string_view of, const std::vector<std::string>& drivers);

/// Values of `hardware` and, for the sensor type `type`, of `source` that name a driver.
std::vector<std::string> robot_drivers();
std::vector<std::string> sensor_drivers(const std::string& type);

/// Whether `clock` is one under which the driver works; throws nothing.
bool works_under(const DriverEntry& driver, ClockMode clock);

}  // namespace mrroc::config
