// How the driver brings drives into service from any state.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "can_rig.hpp"
#include "clock/wall/monotonic.hpp"
#include "drivers/socketcan/can_hardware.hpp"

namespace mrroc::edp {
namespace {

using canopen::DriveMode;
using canopen::DriveState;

/// Advances the time of the simulated drives by so many SYNCs.
void let_pass(const TestBus& bus, const Rack& rack, std::uint64_t syncs) {
  const auto other = bus.open();
  for (const std::uint64_t end = rack.cycles() + syncs; rack.cycles() < end;) {
    const std::uint64_t before = rack.cycles();
    other->send(canopen::sync_frame());
    while (rack.cycles() == before) std::this_thread::yield();
  }
}

bool powered_node(Rack& rack, std::uint32_t node) {
  bool powered = false;
  rack.with([&](auto& nodes) { powered = nodes[node - 1].powered(); });
  return powered;
}

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(CanStart, SecondRunClearsTheFaultOfTheEndOfTheFirst) {
  HeldGantry rig;
  for (int run = 0; run < 3; ++run) {
    rig.connect();
    rig.hardware->open();
    rig.hardware->enable(true);
    rig.run(60);
    EXPECT_EQ(rig.input.fault, ErrorCode::none) << describe(rig.input.fault);
    EXPECT_FALSE(rig.hardware->busy()) << "they are on";
    rig.hardware.reset();
    let_pass(rig.bus, rig.rack, static_cast<std::uint64_t>(4 * rig.table.heartbeat / kCanPeriod));
    rig.rack.with([](auto& nodes) {
      for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::fault) << "no master";
    });
  }
}

/// 6007h = 0: it continues when its master is lost.
TEST(CanStart, DriveWithPowerLosesItBeforeItsObjectsAreWritten) {
  config::DriveTable table = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  for (config::DriveEntry& drive : table.drives) drive.settings.push_back({{0x6007, 0}, "6007h", 0, 2});
  HeldGantry rig(table);
  rig.hardware->open();
  rig.hardware->enable(true);
  rig.run(60);
  const auto count = [&rig](auto predicate) {
    int nodes_so = 0;
    rig.rack.with(
        [&](auto& nodes) { nodes_so = static_cast<int>(std::count_if(nodes.begin(), nodes.end(), predicate)); });
    return nodes_so;
  };
  const auto powered = [](const sim::DriveNode& node) { return node.powered(); };
  ASSERT_EQ(count(powered), 4);
  std::atomic<bool> ended = false;
  int written_under_power = 0;
  const auto ear = rig.bus.open();
  std::thread watch([&] {
    can::Frame frame;
    while (!ended) {
      const bool written = ear->receive(frame, clock::monotonic_ns() + clock::kSecond / 100) &&
                           frame.id > canopen::kSdoRequest && frame.id <= canopen::kSdoRequest + 4 &&
                           (frame.data[0] & 0xe0) == 0x20;
      const bool controlword = frame.data[1] == 0x40 && frame.data[2] == 0x60;
      if (written && !controlword && powered_node(rig.rack, frame.id - canopen::kSdoRequest)) ++written_under_power;
    }
  });
  CanHardware second(table, rig.model.parameters(), kCanPeriod, rig.bus.opener(), kTestTiming, true);
  second.open();
  ended = true;
  watch.join();
  EXPECT_EQ(written_under_power, 0);
  EXPECT_EQ(count(powered), 0);
}

/// The state of a drive that was instructed to store its parameters (1010h).
TEST(CanStart, PdoWithAnotherIdentifierIsFreedFirst) {
  const config::DriveTable good = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  config::DriveTable there = good;
  there.eds = changed_eds("DefaultValue=$NODEID+0x180", "DefaultValue=$NODEID+0x480");
  HeldGantry rig(good, there);
  EXPECT_EQ(rig.refusal(), "");
  rig.run(20);
  EXPECT_EQ(rig.input.fault, ErrorCode::none) << describe(rig.input.fault);
}

TEST(CanStart, PersistentFaultEndsTheStart) {
  HeldGantry rig;
  rig.hardware->open();
  rig.rack.with([](auto& nodes) {
    nodes[1].fail(0x7305);
    nodes[1].keep_fault(true);
  });
  rig.connect();
  const std::string refusal = rig.refusal();
  EXPECT_EQ(refusal.find(describe(ErrorCode::drive_fault)), 0u) << refusal;
  expect_contains(refusal, "drive y, node 2: stays in its fault: error code 7305h, incremental sensor 1 fault");
}

TEST(CanStart, SelfStartingDrivesAreSetUpBeforeTheyContinue) {
  HeldGantry rig;
  rig.rack.with([](auto& nodes) {
    for (sim::DriveNode& node : nodes) node.start_itself(true);
  });
  rig.hardware->open();
  rig.run(20);
  EXPECT_EQ(rig.input.fault, ErrorCode::none) << describe(rig.input.fault);
  const auto boot = [&rig] { rig.rack.with([](auto& nodes) { nodes[1].boot(1); }); };
  boot();
  rig.run(20);
  EXPECT_EQ(rig.input.fault, ErrorCode::drive_restarted);
  rig.rack.with([](auto& nodes) { nodes[1].lose_requests(1); });  // there is time before the next request
  rig.hardware->reset_fault();
  rig.run(5);
  EXPECT_TRUE(rig.hardware->busy());
  boot();  // again, while it is being set up
  for (int i = 0; i < 500 && rig.hardware->busy(); ++i) rig.run(1);
  rig.run(1);
  EXPECT_EQ(rig.input.fault, ErrorCode::none) << describe(rig.input.fault);
}

TEST(CanStart, DriveThatBootsDuringTheSetUpIsSetUpAgain) {
  HeldGantry rig;
  rig.rack.with([](auto& nodes) { nodes[3].lose_requests(1); });  // there is time before the next request
  const auto ear = rig.bus.open();
  std::thread late_reset([&] {
    can::Frame frame;
    while (frame.id != canopen::kSdoRequest + 4) ear->receive(frame, INT64_MAX);
    rig.rack.with([](auto& nodes) { nodes[0].boot(1); });
  });
  EXPECT_EQ(rig.refusal(), "");
  late_reset.join();
  rig.run(1);
  EXPECT_EQ(rig.input.fault, ErrorCode::none) << describe(rig.input.fault);
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_TRUE(node.operational());
  });
}

TEST(CanStart, LostWriteIsRepeated) {
  HeldGantry rig;
  const auto ear = rig.bus.open();
  std::thread loss([&] {
    can::Frame frame;
    while (frame.id != canopen::kSdoRequest + 1 || frame.data[2] != 0x16) ear->receive(frame, INT64_MAX);  // 1600h
    rig.rack.with([](auto& nodes) { nodes[0].lose_requests(1); });
  });
  EXPECT_EQ(rig.refusal(), "");
  loss.join();
  rig.rack.with([](auto& nodes) { nodes[0].lose_requests(1000); });
  rig.connect();
  expect_contains(rig.refusal(), "drive x, node 1: node 1, object 1000h:0: SDO protocol timed out");
}

TEST(CanStart, RepeatedlyBootingDriveIsNotStarted) {
  HeldGantry rig;
  rig.rack.with([](auto& nodes) { nodes[1].boot_at_requests(true); });
  expect_contains(rig.refusal(), "drive y, node 2: it boots again and again");
}

TEST(CanStart, DriveWithoutSwitchReportsIsNotStarted) {
  HeldGantry rig;
  rig.rack.with([](auto& nodes) { nodes[3].withhold_status(true); });
  const std::string refusal = rig.refusal();
  EXPECT_EQ(refusal.find(describe(ErrorCode::hardware_silent)), 0u) << refusal;
  expect_contains(refusal, "node 4: no TPDO 2");
}

TEST(CanStart, ErrorsOfDrivesAreReportedByNameBeforeAnyMotion) {
  const config::DriveTable good = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  config::DriveTable table = good;
  table.drives[2].settings.push_back({{0x6041, 0}, "Statusword", 1, 2});
  expect_contains(HeldGantry(table, good).refusal(),
                  "drive z, node 3: refuses Statusword = 1: attempt to write a read only object");
  table = good;
  table.drives[3].node = 9;
  HeldGantry missing(table, good);
  missing.timing = kShortBoot;
  missing.connect();
  expect_contains(missing.refusal(), "node 9: no boot-up message within 2 s");
}

TEST(CanStart, BusReportsAreAddedToTheErrorOfADriveThatDoesNotBoot) {
  config::DriveTable table = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  table.drives[3].node = 9;
  HeldGantry rig(table, table_for(Gantry{}.parameters(), DriveMode::cyclic_position));
  rig.timing = kShortBoot;
  rig.connect();
  can::Frame passive{0x4, {0, 0x20, 0, 0, 0, 0, 0, 0}};
  passive.error = true;
  std::atomic<bool> refused{false};
  std::thread controller([&] {  // it counts on: the driver opens the bus some time in its start
    for (const auto bus = rig.bus.open(); !refused; std::this_thread::sleep_for(std::chrono::milliseconds(50)))
      bus->send(passive);
  });
  const std::string refusal = rig.refusal();
  refused = true;
  controller.join();
  expect_contains(refusal, "or no wire (error passive: the controller has counted more than 127 errors)");
}

TEST(CanStart, OnlyModesInUseAreRequired) {
  const config::DriveTable good = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  const std::string modes = "DefaultValue=0x000003A0";
  config::DriveTable there = good;
  there.eds = changed_eds(modes, "DefaultValue=0x20");
  expect_contains(HeldGantry(good, there).refusal(),
                  "drive x, node 1: has no mode cyclic synchronous position, expected bit 7 in its supported modes, "
                  "6502h, which are 32");
  there.eds = changed_eds(modes, "DefaultValue=0x80");
  EXPECT_EQ(HeldGantry(good, there).refusal(), "") << "it is synchronised and does not need homing";
  expect_contains(HeldGantry(good, there, false).refusal(), "has no mode homing");
  // 6502h may be left out, 1000h may not
  there.eds = changed_eds("[6502]", "[6503]");
  EXPECT_EQ(HeldGantry(good, there).refusal(), "");
  there.eds = changed_eds("AccessType=ro", "AccessType=wo");
  const std::string unreadable = HeldGantry(good, there).refusal();
  EXPECT_EQ(unreadable.find(describe(ErrorCode::configuration)), 0u) << unreadable;
  expect_contains(unreadable, "object 1000h");
}

}  // namespace
}  // namespace mrroc::edp
