#include <gtest/gtest.h>

#include "vsp/configuration.hpp"
#include "vsp/fakes.hpp"

namespace mrroc::vsp::sampler_configuration_test {
namespace {

struct Offset {
  double value = 0;
};
MRROC_MESSAGE(Offset, value)

struct Broken {
  std::int64_t how = 0;
};
MRROC_MESSAGE(Broken, how)

struct Unknown {
  double value = 0;
};
MRROC_MESSAGE(Unknown, value)

/// v = r + offset.
class OffsetSensor : public FakeSensor {
 public:
  void reconfigure(const Message& configuration) override {
    take_configuration<Offset, Broken>(configuration, [this](const auto& taken) { apply(taken); });
  }

 private:
  void apply(const Offset& offset) {
    check_configured("Offset", "value", offset.value, -1000, 1000, "m");
    zero = -offset.value;
  }
  void apply(const Broken& broken) {
    switch (broken.how) {
      case 0:
        throw SystemError(ErrorCode::configuration, "sensors.fake.key: 1, expected 2");
      case 1:
        throw HardwareError(ErrorCode::sensor_hardware, "the lens is stuck");
      default:
        throw std::runtime_error("something else");
    }
  }
};

class SamplerConfiguration : public ::testing::Test {
 protected:
  template <class T>
  void configure(const T& message, Tick now) {
    sampler.on_request({0, ++requests_}, {SensorRequestKind::configure, 0, pack(message)}, now, sink);
  }
  void read(Tick at, Tick now) { sampler.on_request({1, ++requests_}, {SensorRequestKind::reading, at}, now, sink); }
  void tick(Tick now) {
    sink.now = now;
    sampler.on_tick(now, sink);
  }
  const SensorReading& given(std::size_t i) const { return sink.given.at(i).reading; }

  FakeSource source;
  OffsetSensor sensor;
  RecordingSink sink;
  Sampler sampler{sensor, source, 0};

 private:
  std::uint64_t requests_ = 0;
};

TEST_F(SamplerConfiguration, HoldsFromTheNextReadingOn) {
  read(9, 9);
  configure(Offset{100}, 9);
  read(9, 9);
  read(12, 9);
  tick(9);
  tick(12);
  ASSERT_EQ(sink.given.size(), 4U);
  EXPECT_EQ(given(0).values[0], 9) << "requested before";
  EXPECT_EQ(given(0).configuration, 0U);
  EXPECT_EQ(given(1).channel_count, 0U) << "the answer is no reading";
  EXPECT_EQ(given(1).sequence, 0U);
  EXPECT_EQ(given(1).configuration, 1U);
  EXPECT_EQ(given(1).error.error_class, ErrorClass::none);
  EXPECT_EQ(given(2).values[0], 109) << "of the same tick, with the new one";
  EXPECT_EQ(given(2).configuration, 1U);
  EXPECT_EQ(given(2).sequence, 2U);
  EXPECT_EQ(given(3).values[0], 112);
}

TEST_F(SamplerConfiguration, ARefusedOneChangesNothing) {
  configure(Offset{1}, 1);
  configure(Offset{1e6}, 1);
  configure(Offset{std::numeric_limits<double>::quiet_NaN()}, 1);
  configure(Unknown{}, 1);
  read(1, 1);
  tick(1);
  ASSERT_EQ(sink.given.size(), 5U);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(given(i).error.error_class, ErrorClass::non_fatal) << i;
    EXPECT_EQ(given(i).error.code, ErrorCode::invalid_argument) << i;
    EXPECT_EQ(given(i).configuration, 1U) << i;
  }
  EXPECT_NE(given(1).error.detail.view().find("value 1e+06, expected -1000 to 1000 m"), std::string_view::npos);
  EXPECT_NE(given(3).error.detail.view().find("'Unknown', expected one of: Offset, Broken"), std::string_view::npos);
  EXPECT_EQ(given(4).values[0], 2);
  EXPECT_EQ(given(4).configuration, 1U);
}

TEST_F(SamplerConfiguration, AnyExceptionOfTheTypeIsARefusalOrAFaultOfItsHardware) {
  for (const std::int64_t how : {0, 1, 2}) configure(Broken{how}, 1);
  tick(1);
  ASSERT_EQ(sink.given.size(), 3U);
  EXPECT_EQ(given(0).error.error_class, ErrorClass::non_fatal) << "never an end of the deployment";
  EXPECT_EQ(given(0).error.code, ErrorCode::invalid_argument);
  EXPECT_EQ(given(1).error.error_class, ErrorClass::hardware);
  EXPECT_EQ(given(1).error.code, ErrorCode::sensor_hardware);
  EXPECT_EQ(given(2).error.error_class, ErrorClass::non_fatal);
}

TEST_F(SamplerConfiguration, IsTakenWhileTheHardwareIsSilent) {
  source.state = SourceState::silent;
  configure(Offset{5}, 3);
  tick(3);
  ASSERT_EQ(sink.given.size(), 1U);
  EXPECT_EQ(given(0).configuration, 1U);
  EXPECT_EQ(given(0).error.error_class, ErrorClass::none);
  source.state = SourceState::ready;
  read(4, 4);
  tick(4);
  EXPECT_EQ(given(1).values[0], 9);
}

TEST_F(SamplerConfiguration, TypesWithoutOneRefuseAll) {
  FakeSensor plain;
  Sampler other(plain, source, 0);
  other.on_request({0, 1}, {SensorRequestKind::configure, 0, pack(Offset{1})}, 1, sink);
  other.on_tick(1, sink);
  EXPECT_EQ(given(0).error.code, ErrorCode::invalid_argument);
  EXPECT_EQ(given(0).configuration, 0U);
}

TEST_F(SamplerConfiguration, PublishedReadingsCarryIt) {
  Sampler published(sensor, source, 10);
  published.on_tick(0, sink);
  published.on_request({0, 1}, {SensorRequestKind::configure, 0, pack(Offset{1})}, 4, sink);
  published.on_tick(4, sink);
  published.on_tick(10, sink);
  ASSERT_EQ(sink.given.size(), 3U);
  EXPECT_EQ(given(0).configuration, 0U);
  EXPECT_EQ(given(2).configuration, 1U);
  EXPECT_FALSE(sink.given[2].reply);
}

}  // namespace
}  // namespace mrroc::vsp::sampler_configuration_test
