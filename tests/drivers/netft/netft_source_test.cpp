// The source against a simulated sensor, over UDP and HTTP on loopback. All waits are for conditions.
#include "drivers/netft/netft_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "allocations.hpp"
#include "config/table.hpp"
#include "drivers/netft/netft_rig.hpp"
#include "mrroc/errors.hpp"
#include "sensors/entry.hpp"
#include "sensors/force_torque/force_torque_sensor.hpp"

namespace mrroc::netft::netft_source_test {
namespace {

using vsp::SourceState;

TEST(NetftSource, SupportForceIsTheNegativeOfTheLoad) {
  Rig rig;
  Reader reader(rig);
  EXPECT_TRUE(reader.measures(any_load()));
  EXPECT_EQ(reader.raw().count, 6u);
  EXPECT_NEAR(reader.raw().values[0], -12.5, 2e-6);
  const Wrench other{{0, 1, -2, 3, -4, 5}};
  rig.hold(other);
  EXPECT_TRUE(reader.measures(other));
}

TEST(NetftSource, ReadingOfTheSensorTypeIsTheLoad) {
  Rig rig;
  Reader reader(rig);
  ASSERT_TRUE(reader.measures(any_load()));
  vsp::ForceTorqueSensor sensor;
  sensor.set_up(vsp::entry_of("force_torque", "wrist"), kServoPeriod);
  SensorReading reading;
  sensor.aggregate(reader.raw(), reading);
  EXPECT_EQ(reading.error.code, ErrorCode::none);
  EXPECT_LT((Eigen::Map<const Wrench>(reading.values.data()) - any_load()).cwiseAbs().maxCoeff(), 2e-6);
}

TEST(NetftSource, ReadingsHaveTheTickOfTheirArrival) {
  Rig rig;
  Reader reader(rig);
  Tick last = 0;
  int later = 0;
  EXPECT_TRUE(eventually([&] {
    const Tick before = rig.now();
    const bool ready = reader.read() == SourceState::ready;
    EXPECT_LE(reader.raw().tick, rig.now());
    EXPECT_GE(reader.raw().tick, last);
    if (ready && reader.raw().tick + 2 >= before && reader.raw().tick > last) ++later;
    last = reader.raw().tick;
    return later == 20;
  }));
}

TEST(NetftSource, ConvertsTheUnitsOfTheSensor) {
  sim::NetftSettings settings = free_ports();
  settings.force_unit = "lbf";
  settings.torque_unit = "lbf-in";
  settings.counts_per_force = 1e7;
  settings.counts_per_torque = 2e7;
  Rig rig(settings);
  Reader reader(rig);
  EXPECT_TRUE(reader.measures(any_load()));
  EXPECT_NEAR(reader.source().calibration().newtons_per_count, 4.4482216e-7, 1e-13);
}

TEST(NetftSource, CountsOfTheDeploymentNeedNoPage) {
  sim::NetftSettings settings = free_ports();
  settings.page = "<html>no page of a Net F/T</html>";
  Rig rig(settings);
  EXPECT_THROW(Reader{rig}, config::ConfigurationError);
  NetftOptions options = rig.options();
  options.calibration = Calibration{1e-6, 1e-6};
  Reader reader(rig, options);
  EXPECT_TRUE(reader.measures(any_load()));
}

TEST(NetftSource, SensorThatSendsTooSlowlyIsRefused) {
  sim::NetftSettings settings = free_ports();
  settings.rate = 100;
  Rig rig(settings);
  try {
    Reader reader(rig);
    FAIL();
  } catch (const config::ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("netftapi2.xml: comrdtrate: 100 Hz, expected at least 500 Hz"),
              std::string::npos)
        << error.what();
  }
  NetftOptions options = rig.options();
  options.rate_min = 100;
  Reader reader(rig, options);
  EXPECT_TRUE(reader.measures(any_load()));
}

TEST(NetftSource, MissingSensorIsReportedWithItsAddress) {
  Rig rig;
  rig.server().set_faults({.deaf = true});
  NetftOptions options = rig.options();
  options.calibration = Calibration{1e-6, 1e-6};
  options.start_timeout = 0.1;
  try {
    Reader reader(rig, options);
    FAIL();
  } catch (const HardwareError& error) {
    EXPECT_EQ(error.code(), ErrorCode::sensor_hardware);
    EXPECT_EQ(error.detail(), "127.0.0.1:" + std::to_string(options.port) +
                                  ": no record within 0.1 s, expected a Net F/T that sends by RDT over UDP");
  }
  options.port = 1;  // closed: the host refuses
  EXPECT_THROW(Reader(rig, options), HardwareError);
  options.address = "no such host";
  EXPECT_THROW(Reader(rig, options), HardwareError);
}

TEST(NetftSource, WaitsForASensorThatStarts) {
  sim::NetftSettings settings = free_ports();
  settings.address = "127.93.11.7";  // where others bind no free ports
  {
    const Rig gone(settings);
    settings.port = gone.server().port();
    settings.http_port = gone.server().http_port();
  }
  NetftOptions options;
  options.address = settings.address;
  options.port = settings.port;
  options.http_port = settings.http_port;
  options.start_timeout = 30;
  std::unique_ptr<Rig> late;
  std::thread starter([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    late = std::make_unique<Rig>(settings);
  });
  const links::TestClock clock;
  NetftSource source(options, clock, kServoPeriod);
  starter.join();
  EXPECT_GT(source.counters().records, 0u);
}

TEST(NetftSource, PolledSensorServesTwoClients) {
  sim::NetftSettings settings = free_ports();
  settings.one_client = true;
  Rig rig(settings);
  NetftOptions options = rig.options();
  options.requests = Requests::polled;
  options.timeout = 1;
  Reader first(rig, options), second(rig, options);
  EXPECT_TRUE(eventually([&] { return first.counters().records > 200 && second.counters().records > 200; }));
  EXPECT_TRUE(first.measures(any_load()));
  EXPECT_TRUE(second.measures(any_load()));
  const RdtCounters counters = first.counters();
  EXPECT_GE(counters.requests, counters.records);
}

TEST(NetftSource, StreamEndsWithItsClient) {
  Rig rig;
  {
    Reader reader(rig);
    EXPECT_EQ(rig.server().clients(), 1u);
  }
  EXPECT_TRUE(eventually([&] { return rig.server().clients() == 0; }));
}

TEST(NetftSource, ReadAllocatesNothing) {
  Rig rig;
  Reader reader(rig);
  ASSERT_TRUE(reader.measures(any_load()));
  const auto counted = [&](SourceState state) {
    return eventually([&] {
      SourceState found;
      {
        const test::Counting counting;
        found = reader.read();
      }
      EXPECT_EQ(test::Counting::counted(), 0u);
      return found == state;
    });
  };
  EXPECT_TRUE(counted(SourceState::ready));
  rig.server().set_faults({.status = 0xffffffff});
  EXPECT_TRUE(counted(SourceState::faulty));
  rig.server().set_faults({.silent = true});
  EXPECT_TRUE(counted(SourceState::silent));
}

/// A sensor that answers every request with one record, and allocates nothing.
class FrugalSensor {
 public:
  FrugalSensor() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address = resolve("127.0.0.1", 0);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(socket_.get(), generic(address), size), 0);
    EXPECT_EQ(::getsockname(socket_.get(), generic(address), &size), 0);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  ~FrugalSensor() { thread_.join(); }
  FrugalSensor(const FrugalSensor&) = delete;
  FrugalSensor& operator=(const FrugalSensor&) = delete;

  std::uint16_t port() const { return port_; }

 private:
  /// Until its client stops.
  void serve() {
    Record record;
    for (;;) {
      std::array<std::uint8_t, 64> packet{};
      sockaddr_in from{};
      socklen_t length = sizeof from;
      const ssize_t size = ::recvfrom(socket_.get(), packet.data(), packet.size(), 0, generic(from), &length);
      const auto request =
          decode_request(std::span(packet).first(static_cast<std::size_t>(std::max<ssize_t>(size, 0))));
      if (request && request->command == Command::stop) return;
      record.rdt_sequence = 1;
      record.ft_sequence += 14;
      const auto answer = encode(record);
      ::sendto(socket_.get(), answer.data(), answer.size(), 0, generic(from), length);
    }
  }

  Descriptor socket_;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

TEST(RdtClient, ReceiverAllocatesNothing) {
  FrugalSensor sensor;
  RdtOptions options;
  options.address = "127.0.0.1";
  options.port = sensor.port();
  options.start_timeout = 30;
  options.request_period = 0.001;
  RdtClient client(options);
  ASSERT_TRUE(eventually([&] { return client.counters().records > 10; }));
  const auto before = test::allocations();
  EXPECT_TRUE(eventually([&] { return client.counters().records > 300; }));
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace mrroc::netft::netft_source_test
