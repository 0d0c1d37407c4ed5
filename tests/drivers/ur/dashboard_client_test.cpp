#include "drivers/ur/dashboard_client.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/ur/ur_rig.hpp"

namespace mrroc::ur::dashboard_client_test {
namespace {

DashboardClient connect_to(Controller& controller) {
  const UrOptions options = controller.driver_options();
  return {options.address, options.dashboard_port, 10};
}

TEST(DashboardClient, AsksForTheState) {
  Controller controller;
  DashboardClient dashboard = connect_to(controller);
  EXPECT_EQ(dashboard.robot_mode(), "POWER_OFF");
  EXPECT_EQ(dashboard.safety_status(), "NORMAL");
  EXPECT_THAT(dashboard.program_state(), testing::StartsWith("STOPPED"));
  EXPECT_TRUE(dashboard.is_in_remote_control());
}

TEST(DashboardClient, ReportsWhetherACommandIsAccepted) {
  Controller controller;
  DashboardClient dashboard = connect_to(controller);
  EXPECT_TRUE(dashboard.power_on());
  while (dashboard.robot_mode() != "IDLE") std::this_thread::yield();
  EXPECT_TRUE(dashboard.release_brakes());
  while (dashboard.robot_mode() != "RUNNING") std::this_thread::yield();
  EXPECT_TRUE(dashboard.stop_program());
  EXPECT_TRUE(dashboard.close_safety_popup());
  EXPECT_TRUE(dashboard.power_off());
  controller.servers.with([](VirtualController& c) { c.set_remote_control(false); });
  EXPECT_FALSE(dashboard.is_in_remote_control());
  EXPECT_FALSE(dashboard.power_on());
  EXPECT_THAT(dashboard.answer(), testing::HasSubstr("remote control"));
}

TEST(DashboardClient, AProtectiveStopIsReleasedAfterItsTime) {
  ControllerServers::Options options = free_ports();
  options.controller.unlock_delay = 0.5;
  Controller controller(options);
  DashboardClient dashboard = connect_to(controller);
  // both at the same controller time
  controller.servers.with([](VirtualController& c) {
    c.protective_stop();
    EXPECT_THAT(c.dashboard("unlock protective stop"), testing::HasSubstr("until 5s"));
  });
  while (!dashboard.unlock_protective_stop()) std::this_thread::yield();
  EXPECT_EQ(dashboard.safety_status(), "NORMAL");
}

TEST(DashboardClient, ErrorsNameTheServer) {
  UrOptions options;
  {
    const Controller controller;
    options = controller.driver_options();
  }
  try {
    DashboardClient(options.address, options.dashboard_port, 10);
    FAIL() << "the port is closed";
  } catch (const ConnectionError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("dashboard server at 127.0.0.1:"));
  }
}

}  // namespace
}  // namespace mrroc::ur::dashboard_client_test
