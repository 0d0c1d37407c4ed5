#pragma once

#include <memory>

#include "edp/driver.hpp"

namespace mrroc::edp {

/// The drives of `context.robot` from the library of its driver. Every call into the driver is named: when one crashes,
/// the process says on its standard error which (`GuardedHardware`). Throws SystemError(configuration) as
/// `plugin::load` and the driver's factory, and for a factory that throws anything else or returns nothing. Main
/// thread.
std::unique_ptr<Hardware> load_driver(const DriverContext& context);

}  // namespace mrroc::edp
