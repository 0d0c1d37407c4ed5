#include "edp/drivers/load_driver.hpp"

#include "edp/drivers/driver_calls.hpp"
#include "edp/drivers/guarded_hardware.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::edp {

std::unique_ptr<Hardware> load_driver(const DriverContext& context) {
  const config::DriverEntry& driver = context.robot.driver;
  name_crashes_of(driver.name, driver.library);
  std::unique_ptr<Hardware> hardware = call_driver(driver.name, "its factory", [&] {
    const plugin::Interface& library = plugin::load(driver.library, driver_interface(nullptr));
    return reinterpret_cast<MakeHardware>(library.make)(context);
  });
  if (hardware == nullptr)
    throw SystemError(ErrorCode::configuration, "driver '" + driver.name + "': its factory made no drives");
  return std::make_unique<GuardedHardware>(driver.name, std::move(hardware));
}

}  // namespace mrroc::edp
