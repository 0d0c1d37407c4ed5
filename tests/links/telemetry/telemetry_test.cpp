#include <gtest/gtest.h>

#include <cmath>

#include "links/telemetry/telemetry_publisher.hpp"
#include "links/telemetry/telemetry_reader.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::links {
namespace {

TEST(Telemetry, ReaderGetsTheNewestStateAndNothingIsSentWithoutOne) {
  TestDomain net;
  TelemetryPublisher<RobotState> publisher(net.domain, "t/arm/telemetry");
  RobotState state;
  state.joints = JointVector::Constant(6, 0.5);
  publisher.store(state);
  publisher.publish();
  EXPECT_FALSE(publisher.wanted());
  RobotState received;
  {
    TelemetryReader<RobotState> reader(net.domain, "t/arm/telemetry");
    ASSERT_TRUE(eventually([&] {
      publisher.publish();
      return publisher.wanted();
    }));
    for (Tick tick = 1; tick <= 20; ++tick) {
      state.tick = tick;
      state.joints[0] = static_cast<double>(tick);
      publisher.store(state);
      publisher.publish();
    }
    ASSERT_TRUE(eventually([&] { return reader.take(received) && received.tick == 20; }));
    EXPECT_EQ(received.joints[0], 20);
    publisher.publish();
    EXPECT_FALSE(reader.take(received)) << "it was sent once";
  }
  ASSERT_TRUE(eventually([&] {
    publisher.publish();
    return !publisher.wanted();
  }));
}

/// A publisher that was watched before still has the state of that time.
TEST(Telemetry, NextWatcherGetsNoStateOfTheLastOne) {
  TestDomain net;
  TelemetryPublisher<RobotState> publisher(net.domain, "t/arm/telemetry");
  const auto await = [&](bool wanted) {
    return eventually([&] {
      publisher.publish();
      return publisher.wanted() == wanted;
    });
  };
  RobotState state, received;
  {
    TelemetryReader<RobotState> reader(net.domain, "t/arm/telemetry");
    ASSERT_TRUE(await(true));
    state.tick = 1;
    publisher.store(state);  // no reader is left
  }
  ASSERT_TRUE(await(false));
  TelemetryReader<RobotState> reader(net.domain, "t/arm/telemetry");
  ASSERT_TRUE(await(true));
  state.tick = 2;
  publisher.store(state);
  publisher.publish();
  ASSERT_TRUE(eventually([&] { return reader.take(received); }));
  EXPECT_EQ(received.tick, 2U);
}

TEST(Telemetry, ReadingThatIsNoNumberTravelsUnchanged) {
  TestDomain net;
  TelemetryPublisher<SensorReading> publisher(net.domain, "t/gate/telemetry");
  TelemetryReader<SensorReading> reader(net.domain, "t/gate/telemetry");
  ASSERT_TRUE(eventually([&] {
    publisher.publish();
    return publisher.wanted();
  }));
  SensorReading reading, received;
  reading.channel_count = 2;
  reading.values = {1.5, std::nan("")};
  publisher.store(reading);
  publisher.publish();
  ASSERT_TRUE(eventually([&] { return reader.take(received); }));
  EXPECT_EQ(received.values[0], 1.5);
  EXPECT_TRUE(std::isnan(received.values[1]));
}

}  // namespace
}  // namespace mrroc::links
