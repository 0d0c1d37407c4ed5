#include <gtest/gtest.h>

#include "allocations.hpp"
#include "sensors/force_torque/made_sensor.hpp"

namespace mrroc::vsp::allocation_test {
namespace {

TEST(ForceTorqueAllocation, NoneAfterItsConfiguration) {
  ForceTorqueSensor sensor = made_sensor("force_noise = 0.1\ncutoff = 20.0\ntool_mass = 0.5");
  RobotState state;
  const std::size_t before = test::thread_allocations();
  int errors = 0;
  for (Tick tick = 0; tick < 100; ++tick) {
    state.synchronised = tick > 10;
    sensor.effector_state(state);
    const RawReading r = raw_of(Wrench::Constant(tick % 7 == 0 ? 1000 : 1), tick);
    sensor.track(r);
    sensor.bias(r);
    if (aggregated(sensor, r).error.error_class != ErrorClass::none) ++errors;
  }
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_EQ(errors, 11 + 13);  // ticks 0..10 without a pose; 14, 21, ... 98 beyond the range
}

}  // namespace
}  // namespace mrroc::vsp::allocation_test
