#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "mrroc/conditions/digital_input.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "mrroc/sensors/digital_input.hpp"
#include "sensors/digital_input/made_sensor.hpp"
#include "sensors/played_task.hpp"

namespace mrroc {
namespace {

/// A `DigitalSensor` whose hardware replays `lines`; non-interactive with `period`. A step without robots is 10 ticks.
class DigitalSensorTest : public ::testing::Test {
 protected:
  void play(const std::string& lines, const std::string& toml = "", Tick period = 0) {
    aggregating_ = vsp::made_sensor(toml);
    task_ =
        std::make_unique<vsp::PlayedTask>(aggregating_, "digital_input", "# mrroc readings level\n" + lines, period);
    input_ = std::make_unique<DigitalSensor>(*task_, "gate");
  }
  DigitalSensor& input() { return *input_; }

 private:
  vsp::DigitalInputSensor aggregating_;
  std::unique_ptr<vsp::PlayedTask> task_;
  std::unique_ptr<DigitalSensor> input_;
};

TEST_F(DigitalSensorTest, IsOffBeforeTheFirstReading) {
  play("0 1\n");
  EXPECT_FALSE(input().on());
  EXPECT_EQ(input().rises(), 0U);
  EXPECT_TRUE(std::isnan(input().level()));
}

TEST_F(DigitalSensorTest, WaitEndsWhenTheInputIsOnOrOff) {
  play("0 0\n 20 5\n 40 0\n");
  const Outcome on = Wait({}, {input()}, On{input()});
  EXPECT_EQ(on.end_tick, 20U);
  EXPECT_TRUE(on.by("gate on"));
  EXPECT_EQ(input().level(), 5);
  EXPECT_EQ(Wait({}, {input()}, !On{input()}).end_tick, 40U);
}

TEST_F(DigitalSensorTest, RiseBetweenTwoReadingsIsNotLost) {
  play("0 0\n 13 1\n 14 0\n 17 1\n 18 0\n");
  const Outcome outcome = Wait({}, {input()}, Risen{input()});
  EXPECT_EQ(outcome.end_tick, 20U);
  EXPECT_TRUE(outcome.by("gate risen"));
  EXPECT_FALSE(input().on());
  EXPECT_EQ(input().rises(), 2U);
}

TEST_F(DigitalSensorTest, EveryInstructionWaitsForItsOwnRise) {
  play("0 0\n 13 1\n 25 0\n 33 1\n");
  EXPECT_EQ(Wait({}, {input()}, Risen{input()}).end_tick, 20U);
  EXPECT_EQ(Wait({}, {input()}, Risen{input()}).end_tick, 40U);
}

TEST_F(DigitalSensorTest, RisesCountFromZeroAfterABias) {
  play("0 0\n 13 1\n 25 0\n 33 1\n");
  Wait({}, {input()}, Risen{input()});
  input().bias();
  EXPECT_EQ(input().rises(), 0U);
  EXPECT_EQ(Wait({}, {input()}, Risen{input()}).end_tick, 40U);
  EXPECT_EQ(input().rises(), 1U);
}

TEST_F(DigitalSensorTest, RiseIsDetectedAfterABiasOfAnotherProgram) {
  play("0 0\n 3 1\n 5 0\n 7 1\n 9 0\n 33 1\n");
  Wait({}, {input()}, When{"two", [this] { return input().rises() == 2; }});
  Risen risen{input()};
  risen.start();
  EXPECT_FALSE(risen.evaluate());
  input().bias();  // the effect of another program's request
  EXPECT_FALSE(risen.evaluate());
  Wait({}, {input()}, On{input()});
  EXPECT_TRUE(risen.evaluate());
}

TEST_F(DigitalSensorTest, DebouncedInputIsPublishedToo) {
  play("0 0\n 10 1\n 12 0\n 14 1\n", "debounce = 0.01", 5);
  const Outcome outcome = Wait({}, {input()}, On{input()});
  EXPECT_EQ(outcome.end_tick, 20U);  // steady from 14 on, switched at 19, published at 20
  EXPECT_EQ(input().rises(), 1U);
}

}  // namespace
}  // namespace mrroc
