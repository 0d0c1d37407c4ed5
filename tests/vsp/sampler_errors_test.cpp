#include <gtest/gtest.h>

#include <cmath>

#include "mrroc/errors.hpp"
#include "vsp/fakes.hpp"

namespace mrroc::vsp::sampler_errors_test {
namespace {

class SamplerErrorsTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(read().error.error_class, ErrorClass::none); }
  SensorReading read(SensorRequestKind kind = SensorRequestKind::reading) {
    sampler.on_request({0, 1}, {kind, 0}, ++now_, sink);
    sampler.on_tick(now_, sink);
    return sink.given.back().reading;
  }
  /// An error has a class, a code, a text and no usable value; the next reading is valid.
  void expect_error_then_recovery(ErrorClass error_class, ErrorCode code, const std::string& detail) {
    const SensorReading reading = read();
    EXPECT_EQ(reading.error.error_class, error_class);
    EXPECT_EQ(reading.error.code, code);
    EXPECT_EQ(reading.error.detail.view(), detail);
    EXPECT_TRUE(std::isnan(reading.values[0]));
    source = FakeSource{};
    sensor.write = true;
    const SensorReading next = read();
    EXPECT_EQ(next.error.error_class, ErrorClass::none);
    EXPECT_TRUE(next.error.detail.empty());
    EXPECT_EQ(next.values[0], 3);
    EXPECT_EQ(next.sequence, 3U);
  }

  FakeSource source;
  FakeSensor sensor;
  RecordingSink sink;
  Sampler sampler{sensor, source, 0};

 private:
  Tick now_ = 0;
};

TEST_F(SamplerErrorsTest, NonFiniteRawValuesAreAHardwareError) {
  source.bad = true;
  expect_error_then_recovery(ErrorClass::hardware, ErrorCode::sensor_hardware,
                             "raw value in is nan, expected a finite number");
}

TEST_F(SamplerErrorsTest, InfiniteRawValuesAreAHardwareErrorToo) {
  source.bad = true;
  source.bad_value = -std::numeric_limits<double>::infinity();
  expect_error_then_recovery(ErrorClass::hardware, ErrorCode::sensor_hardware,
                             "raw value in is -inf, expected a finite number");
}

TEST_F(SamplerErrorsTest, TooFewRawValuesAreAHardwareError) {
  source.count = 0;
  expect_error_then_recovery(ErrorClass::hardware, ErrorCode::sensor_hardware, "0 raw values, expected 1");
}

TEST_F(SamplerErrorsTest, SilentSourceIsAHardwareError) {
  source.state = SourceState::silent;
  expect_error_then_recovery(ErrorClass::hardware, ErrorCode::sensor_hardware, "silent at tick 2");
}

TEST_F(SamplerErrorsTest, FaultOfTheHardwareIsAHardwareErrorWithItsText) {
  source.state = SourceState::faulty;
  expect_error_then_recovery(ErrorClass::hardware, ErrorCode::sensor_hardware, "the gauge is broken");
}

TEST_F(SamplerErrorsTest, SourceThatIsNotReadyIsANonFatalError) {
  source.state = SourceState::not_ready;
  expect_error_then_recovery(ErrorClass::non_fatal, ErrorCode::sensor_not_ready, "no hardware reading yet at tick 2");
}

TEST_F(SamplerErrorsTest, NonFiniteAggregateIsANonFatalError) {
  sensor.write = false;
  expect_error_then_recovery(ErrorClass::non_fatal, ErrorCode::not_finite, "channel out is inf");
}

TEST_F(SamplerErrorsTest, BiasOnAFaultyRawReadingKeepsTheZero) {
  source.bad = true;
  EXPECT_EQ(read(SensorRequestKind::bias).error.code, ErrorCode::sensor_hardware);
  EXPECT_EQ(sensor.zero, 0);
}

TEST_F(SamplerErrorsTest, FaultyRawReadingIsNotTracked) {
  sensor.is_continuous = true;
  source.bad = true;
  read();
  EXPECT_EQ(sensor.tracked_count, 0U);
  source.bad = false;
  read();
  EXPECT_EQ(sensor.tracked_count, 1U);
}

template <class Count>
class CountedSensor : public FakeSensor {
 public:
  std::vector<Channel> channels() const override { return std::vector<Channel>(Count::channels, {"c", "1"}); }
  std::vector<Channel> raw_channels() const override { return std::vector<Channel>(Count::raw, {"r", "1"}); }
};

struct NoChannels {
  static constexpr std::size_t channels = 0, raw = 1;
};
struct TooManyRaw {
  static constexpr std::size_t channels = 1, raw = kMaxRawValues + 1;
};

TEST(SamplerConstruction, RefusesASensorThatDoesNotFitAReading) {
  FakeSource source;
  CountedSensor<NoChannels> none;
  CountedSensor<TooManyRaw> many;
  EXPECT_THROW(Sampler(none, source, 0), SystemError);
  EXPECT_THROW(Sampler(many, source, 0), SystemError);
}

}  // namespace
}  // namespace mrroc::vsp::sampler_errors_test
