#include "sim/netft/netft_server.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <system_error>

#include "mrroc/errors.hpp"
#include "sim/netft/netft_process.hpp"

namespace mrroc::sim::netft_server_test {
namespace {

NetftSettings free_ports() {
  NetftSettings settings;
  settings.port = settings.http_port = 0;
  return settings;
}

NetftLoad no_load() {
  return [](double) { return Wrench{Wrench::Zero()}; };
}

TEST(SimulatedNetft, RefusesImpossibleSettings) {
  const auto refuses = [](void (*change)(NetftSettings&)) {
    NetftSettings settings = free_ports();
    change(settings);
    EXPECT_THROW(NetftServer(settings, no_load()), std::invalid_argument);
  };
  refuses([](NetftSettings& settings) { settings.rate = 0; });
  refuses([](NetftSettings& settings) { settings.rate = 7001; });
  refuses([](NetftSettings& settings) { settings.buffer = 0; });
  refuses([](NetftSettings& settings) { settings.buffer = 41; });
  refuses([](NetftSettings& settings) { settings.force_unit = "stone"; });
  refuses([](NetftSettings& settings) { settings.torque_unit = "N"; });
  refuses([](NetftSettings& settings) { settings.counts_per_force = 0; });
}

TEST(SimulatedNetft, RefusesAPortInUse) {
  const NetftServer first(free_ports(), no_load());
  NetftSettings settings = free_ports();
  settings.http_port = first.http_port();
  EXPECT_THROW(NetftServer(settings, no_load()), std::system_error);
  settings = free_ports();
  settings.port = first.port();
  EXPECT_THROW(NetftServer(settings, no_load()), std::system_error);
}

TEST(SimulatedNetft, LoadOfTheWorldIsTheNegativeSupport) {
  const auto world = std::make_unique<world::WorldMemory>();
  const NetftLoad load = load_of_world(*world, 2);
  EXPECT_EQ(load(0), (Wrench{Wrench::Zero()})) << "before the first measurement";
  RawReading reading;
  reading.count = 6;
  for (std::size_t i = 0; i < 6; ++i) reading.values[i] = static_cast<double>(i) + 1;
  world->readings[2].store(reading);
  EXPECT_EQ(load(0), (Wrench{{-1, -2, -3, -4, -5, -6}}));
}

TEST(SimulatedNetft, ProcessIsNamedAfterItsSensor) {
  config::Deployment deployment;
  deployment.sensors.resize(2);
  deployment.sensors[0].name = "eye";
  deployment.sensors[1].name = "wrist";
  deployment.sensors[1].driver.emplace().name = "netft";
  EXPECT_EQ(sensor_of_process(deployment, "wrist_netft"), 1u);
  EXPECT_THROW(sensor_of_process(deployment, "wrist"), SystemError);
}

}  // namespace
}  // namespace mrroc::sim::netft_server_test
