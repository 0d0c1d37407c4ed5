// A sensor that is silent, faulty or restarts, and a network that loses, doubles and reorders its records.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "drivers/netft/netft_rig.hpp"
#include "drivers/netft/netft_source.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::netft::netft_disturbance_test {
namespace {

using vsp::SourceState;

TEST(NetftSource, SilentSensorIsReportedAndFoundAgain) {
  Rig rig;
  Reader reader(rig);
  ASSERT_TRUE(reader.measures(any_load()));
  rig.server().set_faults({.silent = true});
  EXPECT_TRUE(reader.reaches(SourceState::silent));
  const auto requests = reader.counters().requests;
  EXPECT_TRUE(eventually([&] { return reader.counters().requests > requests; }));
  const Wrench other{{1, 2, 3, 4, 5, 6}};
  rig.hold(other);
  rig.server().set_faults({});
  EXPECT_TRUE(reader.measures(other));
}

TEST(NetftSource, FrozenSensorIsSilent) {
  Rig rig;
  Reader reader(rig);
  ASSERT_TRUE(reader.measures(any_load()));
  rig.server().set_faults({.frozen = true});
  EXPECT_TRUE(reader.reaches(SourceState::silent));
  EXPECT_GT(reader.counters().repeated, 0u);
  rig.server().set_faults({});
  EXPECT_TRUE(reader.reaches(SourceState::ready));
}

TEST(NetftSource, StatusOfTheSensorIsItsFault) {
  Rig rig;
  Reader reader(rig);
  ASSERT_TRUE(reader.measures(any_load()));
  rig.server().set_faults({.status = 0x80000400});
  EXPECT_TRUE(reader.reaches(SourceState::faulty));
  EXPECT_EQ(reader.fault(), "the Net F/T reports status 0x80000400: analog board watchdog timeout");
  EXPECT_TRUE(eventually([&] { return reader.counters().invalid > 0; }));
  rig.server().set_faults({.status = kErrorSummary | kMonitorCondition});
  EXPECT_TRUE(reader.reaches(SourceState::ready)) << "the user's own condition";
}

TEST(NetftSource, OverloadIsItsFault) {
  Rig rig;
  Reader reader(rig);
  rig.hold(Wrench{{2000, 0, 0, 0, 0, 0}});
  EXPECT_TRUE(reader.reaches(SourceState::faulty));
  EXPECT_EQ(reader.fault(), "the Net F/T reports status 0x80020000: transducer saturation or A/D error");
  rig.hold(any_load());
  EXPECT_TRUE(reader.measures(any_load()));
}

TEST(NetftSource, SensorThatRestartsIsFoundAgain) {
  Rig rig;
  Reader reader(rig);
  ASSERT_TRUE(reader.measures(any_load()));
  int waits = 0;
  // a count that begins again is recognised only where the old one had gone further
  EXPECT_TRUE(eventually([&] {
    if (waits++ % 1000 == 999) rig.server().restart();
    return reader.counters().sensor_restarts > 0;
  }));
  EXPECT_TRUE(reader.measures(any_load()));
}

TEST(NetftSource, SensorBiasIsLostByARestart) {
  Rig rig;
  NetftOptions options = rig.options();
  options.set_bias = true;
  Reader reader(rig, options);
  EXPECT_TRUE(reader.measures(Wrench::Zero()));
  rig.hold(2 * any_load());
  EXPECT_TRUE(reader.measures(any_load()));
  int waits = 0;
  EXPECT_TRUE(eventually([&] {
    if (waits++ % 1000 == 999) rig.server().restart();
    return reader.read() == SourceState::faulty;
  }));
  EXPECT_NE(reader.fault().find("restarted and lost its zero"), std::string::npos);
}

class NetftLoss : public testing::TestWithParam<double> {};

TEST_P(NetftLoss, LostRecordsAreCounted) {
  Rig rig;
  Reader reader(rig);
  rig.server().set_faults({.loss = GetParam()});
  EXPECT_TRUE(eventually([&] { return reader.counters().records > 3000; }));
  const RdtCounters counters = reader.counters();
  EXPECT_GT(counters.lost, 0u);
  EXPECT_LT(counters.lost, counters.records);
  EXPECT_TRUE(reader.measures(any_load()));
}

INSTANTIATE_TEST_SUITE_P(Percent, NetftLoss, testing::Values(0.01, 0.05, 0.2));

TEST(NetftSource, DoubledRecordsAreCountedAndIgnored) {
  Rig rig;
  Reader reader(rig);
  rig.server().set_faults({.doubled = 0.2});
  EXPECT_TRUE(eventually([&] { return reader.counters().doubled > 100; }));
  EXPECT_TRUE(reader.measures(any_load()));
}

TEST(NetftSource, GarbageIsCountedAndIgnored) {
  Rig rig;
  Reader reader(rig);
  rig.server().set_faults({.garbage = 0.5});
  EXPECT_TRUE(eventually([&] { return reader.counters().malformed > 100; }));
  EXPECT_TRUE(reader.measures(any_load()));
}

TEST(RdtClient, OvertakenRecordIsNeverTheNewest) {
  Rig rig;
  RdtOptions options;
  options.address = "127.0.0.1";
  options.port = rig.server().port();
  options.start_timeout = 30;
  RdtClient client(options);
  rig.server().set_faults({.doubled = 0.1, .reordered = 0.3});
  std::uint32_t last = client.newest().record.ft_sequence;
  EXPECT_TRUE(eventually([&] {
    const std::uint32_t number = client.newest().record.ft_sequence;
    EXPECT_LE(last, number);
    last = number;
    return client.counters().late > 200;
  }));
  EXPECT_EQ(client.counters().sensor_restarts, 0u);
}

}  // namespace
}  // namespace mrroc::netft::netft_disturbance_test
