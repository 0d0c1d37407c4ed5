#include "sensors/operator_input/operator_input_sensor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "allocations.hpp"
#include "mrroc/errors.hpp"
#include "sensors/operator_input/made_sensor.hpp"

namespace mrroc::vsp {
namespace {

TEST(OperatorInputSensor, TakesTheFirstAnswerAfterTheQuestionAndThenTheNewest) {
  EXPECT_TRUE(rc::check([] {
    OperatorInputSensor sensor = made_sensor();
    const auto earlier = *rc::gen::inRange(0, 100);
    const auto later = *rc::gen::inRange(0, 3);
    const double value = 0.5 * *rc::gen::inRange(-100, 100);
    RC_ASSERT(sensor.bias(raw(earlier, 77)));
    const SensorReading v = aggregated(sensor, raw(earlier + later, value));
    RC_ASSERT(v.values[0] == (later > 0 ? 1 : 0));
    RC_ASSERT(v.values[1] == (later > 0 ? value : 0));
  }));
}

TEST(OperatorInputSensor, RefusesAMinimumAnswerAboveTheMaximum) {
  try {
    made_sensor("min = 3\nmax = 2");
    FAIL() << "no answer would be valid";
  } catch (const SystemError& error) {
    EXPECT_NE(std::string{error.what()}.find("sensors.parts.min"), std::string::npos) << error.what();
  }
}

TEST(OperatorInputSensor, DoesNotAllocateAfterItsConfiguration) {
  OperatorInputSensor sensor = made_sensor();
  const std::size_t before = test::thread_allocations();
  sensor.bias(raw(1, 5));
  const double value = aggregated(sensor, raw(2, 6)).values[1];
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_EQ(value, 6);
}

}  // namespace
}  // namespace mrroc::vsp
