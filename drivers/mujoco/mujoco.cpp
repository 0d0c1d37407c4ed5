#include "drivers/mujoco/mujoco_hardware.hpp"
#include "edp/driver.hpp"

namespace {

using namespace mrroc;

std::unique_ptr<edp::Hardware> make(const edp::DriverContext& context) {
  using Timing = edp::MujocoHardware::Timing;
  return std::make_unique<edp::MujocoHardware>(context.model, *context.world, context.slot,
                                               context.simulated_time ? Timing::lockstep : Timing::real,
                                               context.robot.synchronised);
}

}  // namespace

MRROC_DRIVER(make)
