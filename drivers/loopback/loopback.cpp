#include "drivers/loopback/loopback_hardware.hpp"
#include "drivers/loopback/regulated_loopback.hpp"
#include "edp/driver.hpp"

namespace {

using namespace mrroc;

template <class Loopback>
std::unique_ptr<edp::Hardware> make_loopback(const edp::DriverContext& context) {
  auto loopback = std::make_unique<Loopback>(context.model, context.servo_period, context.robot.synchronised);
  if (context.robot.emergency_stop) loopback->close(*context.robot.emergency_stop);
  return loopback;
}

std::unique_ptr<edp::Hardware> make(const edp::DriverContext& context) {
  return context.model.parameters().drives.regulate_themselves() ? make_loopback<edp::RegulatedLoopback>(context)
                                                                 : make_loopback<edp::LoopbackHardware>(context);
}

}  // namespace

MRROC_DRIVER(make)
