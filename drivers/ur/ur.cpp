#include "drivers/ur/driver_keys.hpp"
#include "drivers/ur/lockstep.hpp"
#include "drivers/ur/ur_hardware.hpp"
#include "edp/driver.hpp"

namespace {

using namespace mrroc;

constexpr double kStandInTimeout = 30;  // s: it waits for the simulated world

std::unique_ptr<edp::Hardware> make(const edp::DriverContext& context) {
  const config::DriverEntry& driver = context.robot.driver;
  ur::UrOptions options = ur::options_of(driver);
  options.payload_mass = context.robot.load.mass;
  Eigen::Map<Eigen::Vector3d>(options.payload_centre.data()) = context.robot.load.centre;
  if (driver.simulated) options.open_timeout = kStandInTimeout;
  if (context.simulated_time) {
    options.lockstep = true;
    options.timeout = ur::kLockstepAnswerTimeout;
  }
  return std::make_unique<ur::UrHardware>(options, context.model, context.servo_period);
}

}  // namespace

MRROC_DRIVER(make)
