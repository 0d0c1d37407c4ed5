#include "mrroc/sensors/conveyor_encoder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "sensors/conveyor_encoder/made_sensor.hpp"
#include "sensors/played_task.hpp"

namespace mrroc {
namespace {

/// A `ConveyorEncoder` whose hardware replays `lines`; non-interactive with `period`.
class ConveyorEncoderTest : public ::testing::Test {
 protected:
  void play(const std::string& lines, Tick period = 0) {
    task_ = std::make_unique<vsp::PlayedTask>(aggregating_, "conveyor_encoder",
                                              "# mrroc readings travel speed\n" + lines, period);
    encoder_ = std::make_unique<ConveyorEncoder>(*task_, "encoder");
  }
  ConveyorEncoder& encoder() { return *encoder_; }

 private:
  vsp::ConveyorEncoderSensor aggregating_ = vsp::made_sensor("resolution = 0.0");
  std::unique_ptr<vsp::PlayedTask> task_;
  std::unique_ptr<ConveyorEncoder> encoder_;
};

TEST_F(ConveyorEncoderTest, HasNoValueBeforeTheFirstReading) {
  play("0 1 0\n");
  EXPECT_TRUE(encoder().interactive());
  EXPECT_TRUE(std::isnan(encoder().position()));
  EXPECT_TRUE(std::isnan(encoder().velocity()));
}

TEST_F(ConveyorEncoderTest, WaitEndsWhenTheBeltHasTravelledTheDistance) {
  play("0 5 0.1\n 20 5.05 0.1\n 40 5.1 0.1\n 60 5.15 0.08\n");
  const Outcome outcome = Wait({}, {encoder()}, BeltTravelled{encoder(), 0.12});
  EXPECT_EQ(outcome.end_tick, 60U);
  EXPECT_EQ(encoder().position(), 5.15);
  EXPECT_EQ(encoder().velocity(), 0.08);
  EXPECT_TRUE(outcome.by("encoder travelled 0.12 m"));
}

TEST_F(ConveyorEncoderTest, TravelAlsoCountsBackwards) {
  play("0 0 0\n 20 -0.1 -0.1\n 50 -0.2 -0.1\n", 10);
  EXPECT_EQ(Wait({}, {encoder()}, BeltTravelled{encoder(), 0.15}).end_tick, 50U);
}

TEST_F(ConveyorEncoderTest, EveryInstructionMeasuresFromItsStart) {
  play("0 0 0\n 20 0.1 0.1\n 40 0.2 0.1\n");
  EXPECT_EQ(Wait({}, {encoder()}, BeltTravelled{encoder(), 0.1}).end_tick, 20U);
  EXPECT_EQ(Wait({}, {encoder()}, BeltTravelled{encoder(), 0.1}).end_tick, 40U);
}

TEST_F(ConveyorEncoderTest, BiasMakesThePresentPositionZero) {
  play("0 5 0\n 20 5.05 0.1\n");
  encoder().bias();
  Wait({}, {encoder()}, BeltTravelled{encoder(), 0.04});
  EXPECT_DOUBLE_EQ(encoder().position(), 5.05 - 5);
}

TEST_F(ConveyorEncoderTest, BeltTravelledRefusesInvalidDistances) {
  play("0 1 0\n");
  EXPECT_THROW(BeltTravelled(encoder(), 0), NonFatalError);
  EXPECT_THROW(BeltTravelled(encoder(), -1), NonFatalError);
  EXPECT_THROW(BeltTravelled(encoder(), std::numeric_limits<double>::quiet_NaN()), NonFatalError);
}

}  // namespace
}  // namespace mrroc
