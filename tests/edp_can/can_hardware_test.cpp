#include "edp/can/can_hardware.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "can_rig.hpp"

namespace mrroc::edp {
namespace {

using canopen::DriveMode;
using canopen::DriveState;

constexpr double kIncrement = 2 * std::numbers::pi / 4000;

class EveryMode : public testing::TestWithParam<DriveMode> {};

TEST_P(EveryMode, TheRobotGoesWhereItIsSent) {
  CanRig<Gantry> rig(GetParam());
  ASSERT_TRUE(rig.seen().enabled) << describe(rig.seen().fault.code);
  const JointVector begin = rig.seen().joints;
  const JointVector way = (JointVector(4) << 0.2, -0.1, 0.15, 0.3).finished();
  ASSERT_FALSE(rig.send(relative_joints(way, 500)));
  rig.run(700);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.error_class, ErrorClass::none) << rig.replies[0].state.error.detail.view();
  EXPECT_LT((rig.seen().joints - begin - way).cwiseAbs().maxCoeff() * GearedModel::kGear, 20 * kIncrement);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
  EXPECT_LT((rig.rack.shafts() - rig.seen().motors).cwiseAbs().maxCoeff(), 20 * kIncrement) << "what the plant says";
}

TEST_P(EveryMode, WhoIsSwitchedOffInMotionIsStoppedByHisDrives) {
  CanRig<Gantry> rig(GetParam());
  rig.send(relative_joints(JointVector::Constant(4, 0.4), 600));
  rig.run(300);
  ASSERT_GT(rig.seen().velocity.norm(), 0.1) << "it is under way";
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::operation_enabled);
  });
  rig.hardware.enable(false);
  rig.run(400);
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::switch_on_disabled);
  });
  const JointVector there = rig.rack.shafts();
  rig.run(20);
  EXPECT_EQ(rig.rack.shafts(), there);
}

INSTANTIATE_TEST_SUITE_P(Can, EveryMode,
                         testing::Values(DriveMode::cyclic_position, DriveMode::cyclic_velocity,
                                         DriveMode::cyclic_torque),
                         [](const auto& each) {
                           return std::string(each.param == DriveMode::cyclic_position   ? "Position"
                                              : each.param == DriveMode::cyclic_velocity ? "Velocity"
                                                                                         : "Torque");
                         });

TEST(CanHardware, AnEmergencyStopEndsTheSwitchingOn) {
  CanRig<Gantry> rig(DriveMode::cyclic_position);
  rig.servo.use_emergency_stop(rig.operators);
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  rig.operators.press();
  rig.run(200);
  rig.operators.reset();
  rig.rack.with([](auto& nodes) { nodes[2].hold_back(true); });
  ASSERT_FALSE(rig.send(recover));
  rig.run(50);
  rig.rack.with([](auto& nodes) { EXPECT_EQ(nodes[0].state(), DriveState::switched_on); });
  rig.operators.press();
  rig.run(10);
  rig.rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::switch_on_disabled);
    nodes[2].hold_back(false);
  });
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.code, ErrorCode::emergency_stop);
  rig.operators.reset();
  ASSERT_FALSE(rig.send(recover));
  rig.run(100);
  EXPECT_TRUE(rig.seen().enabled);
}

TEST(CanHardware, ADriveThatCountsBackwardsAndInUnitsOfItsOwnIsNoOther) {
  config::DriveTable table = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  table.drives[1].units_per_turn = -4000;
  table.drives[2].units_per_turn = 65536;
  table.drives[3].units_per_turn = -1000;
  CanRig<Gantry> rig(table, true);
  const JointVector begin = rig.seen().joints;
  const JointVector way = JointVector::Constant(4, 0.1);
  rig.send(relative_joints(way, 400));
  rig.run(500);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none) << describe(rig.seen().fault.code);
  EXPECT_LT((rig.seen().joints - begin - way).cwiseAbs().maxCoeff() * GearedModel::kGear, 60 * kIncrement);
}

TEST_P(EveryMode, NoAxisIsLetGoBeforeAllDrivesAreReady) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), GetParam());
  const TestBus bus;
  Rack rack(table, model, bus, true);
  CanHardware hardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
  hardware.open();
  rack.with([](auto& nodes) { nodes[2].hold_back(true); });
  hardware.enable(true);
  Tick tick = 0;
  HardwareInput input;
  const auto run = [&](Tick ticks) {
    for (const Tick end = tick + ticks; tick < end; ++tick) {
      hardware.read(tick, input);
      hardware.set_points(input.motors, JointVector::Zero(4));
      hardware.write(tick, JointVector::Zero(4));
      rack.with([](auto& nodes) {
        if (nodes[2].state() != DriveState::ready_to_switch_on) return;
        for (const sim::DriveNode& node : nodes) EXPECT_FALSE(node.powered());
      });
    }
  };
  run(100);
  EXPECT_TRUE(hardware.busy());
  rack.with([](auto& nodes) {
    EXPECT_EQ(nodes[0].state(), DriveState::switched_on);
    nodes[2].hold_back(false);
  });
  run(20);
  EXPECT_FALSE(hardware.busy());
  rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::operation_enabled);
    nodes[2].hold_back(true);
  });
  // and who is not ready in time is named, not those that wait for him
  hardware.enable(false);
  run(100);
  hardware.enable(true);
  run(1100);
  EXPECT_EQ(input.fault, ErrorCode::drive_not_ready);
  EXPECT_EQ(input.fault_axis, 2);
}

TEST(CanHardware, TheEndOfTheProcessLeavesNoDriveWithPower) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true);
  {
    CanHardware hardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
    hardware.open();
    hardware.enable(true);
    HardwareInput input;
    input.motors = input.current = JointVector::Zero(4);
    for (Tick tick = 0; tick < 20; ++tick) {
      hardware.read(tick, input);
      hardware.set_points(input.motors, JointVector::Zero(4));
      hardware.write(tick, JointVector::Zero(4));
    }
    EXPECT_FALSE(hardware.busy()) << "they are on";
  }
  const auto powered = [&rack] {
    bool any = false;
    rack.with([&any](auto& nodes) {
      for (const sim::DriveNode& node : nodes) any = any || node.powered();
    });
    return any;
  };
  for (int i = 0; i < 5000 && powered(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_FALSE(powered());
  // a second master finds them, whatever the first has left
  CanHardware hardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
  hardware.open();
  rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_FALSE(node.powered());
  });
}

/// Time of the simulated drives goes by: that of so many SYNCs.
void let_pass(const TestBus& bus, const Rack& rack, std::uint64_t syncs) {
  const auto other = bus.open();
  for (const std::uint64_t end = rack.cycles() + syncs; rack.cycles() < end;) {
    const std::uint64_t before = rack.cycles();
    other->send(canopen::sync_frame());
    while (rack.cycles() == before) std::this_thread::yield();
  }
}

TEST(CanHardware, ASecondRunClearsTheFaultThatTheEndOfTheFirstHasLeft) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true);
  for (int run = 0; run < 3; ++run) {
    auto hardware = std::make_unique<CanHardware>(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
    hardware->open();
    hardware->enable(true);
    HardwareInput input;
    for (Tick tick = 0; tick < 60; ++tick) {
      hardware->read(tick, input);
      hardware->set_points(input.motors, JointVector::Zero(4));
      hardware->write(tick, JointVector::Zero(4));
    }
    EXPECT_EQ(input.fault, ErrorCode::none) << describe(input.fault);
    EXPECT_FALSE(hardware->busy()) << "they are on";
    hardware.reset();
    let_pass(bus, rack, static_cast<std::uint64_t>(4 * table.heartbeat / kCanPeriod));
    rack.with([](auto& nodes) {
      for (const sim::DriveNode& node : nodes) EXPECT_EQ(node.state(), DriveState::fault) << "no master";
    });
  }
}

TEST(CanHardware, AFaultThatStaysEndsTheStart) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true);
  CanHardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true).open();
  rack.with([](auto& nodes) {
    nodes[1].fail(0x7305);
    nodes[1].keep_fault(true);
  });
  CanHardware hardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
  try {
    hardware.open();
    FAIL() << "it has started";
  } catch (const HardwareError& error) {
    EXPECT_EQ(error.code(), ErrorCode::drive_fault);
    EXPECT_NE(std::string(error.what())
                  .find("drive y, node 2: stays in its fault: error code 7305h, incremental sensor 1 fault"),
              std::string::npos)
        << error.what();
  }
}

TEST(CanHardware, DrivesThatStartThemselvesAreSetUpBeforeTheyGoOn) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true);
  rack.with([](auto& nodes) {
    for (sim::DriveNode& node : nodes) node.start_itself(true);
  });
  CanHardware hardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
  hardware.open();
  Tick tick = 0;
  HardwareInput input;
  const auto run = [&](Tick ticks) {
    for (const Tick end = tick + ticks; tick < end; ++tick) {
      hardware.read(tick, input);
      hardware.set_points(input.motors, JointVector::Zero(4));
      hardware.write(tick, JointVector::Zero(4));
    }
  };
  run(20);
  EXPECT_EQ(input.fault, ErrorCode::none) << describe(input.fault);
  const auto boot = [&rack] { rack.with([](auto& nodes) { nodes[1].boot(1); }); };
  boot();
  run(20);
  EXPECT_EQ(input.fault, ErrorCode::drive_restarted);
  hardware.reset_fault();
  run(5);
  boot();  // again, while it is being set up, or just after
  const auto settle = [&] {
    for (int i = 0; i < 500 && hardware.busy(); ++i) run(1);
    run(1);
  };
  settle();
  if (input.fault == ErrorCode::drive_restarted) {
    hardware.reset_fault();
    settle();
  }
  EXPECT_EQ(input.fault, ErrorCode::none) << describe(input.fault);
}

TEST(CanHardware, WhoBootsOnceMoreWhileOthersAreSetUpIsSetUpAnew) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true);
  rack.with([](auto& nodes) { nodes[3].lose_requests(1); });  // until it is asked again there is time
  const auto ear = bus.open();
  std::thread late_reset([&] {
    can::Frame frame;
    while (frame.id != canopen::kSdoRequest + 4) ear->receive(frame, INT64_MAX);
    rack.with([](auto& nodes) { nodes[0].boot(1); });
  });
  CanHardware hardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
  EXPECT_NO_THROW(hardware.open());
  late_reset.join();
  HardwareInput input;
  hardware.read(0, input);
  EXPECT_EQ(input.fault, ErrorCode::none) << describe(input.fault);
  rack.with([](auto& nodes) {
    for (const sim::DriveNode& node : nodes) EXPECT_TRUE(node.operational());
  });
}

TEST(CanHardware, WhoBootsAgainAndAgainIsNotStarted) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true);
  rack.with([](auto& nodes) { nodes[1].boot_at_requests(true); });
  CanHardware hardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
  std::string problem;
  try {
    hardware.open();
  } catch (const HardwareError& error) {
    problem = error.what();
  }
  EXPECT_NE(problem.find("drive y, node 2: it boots again and again"), std::string::npos) << problem;
}

TEST(CanHardware, ADriveThatTellsNoSwitchesIsNotStarted) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true);
  rack.with([](auto& nodes) { nodes[3].withhold_status(true); });
  CanHardware hardware(table, model.parameters(), kCanPeriod, bus.open(), kTestTiming, true);
  try {
    hardware.open();
    FAIL() << "it has started";
  } catch (const HardwareError& error) {
    EXPECT_EQ(error.code(), ErrorCode::hardware_silent);
    EXPECT_NE(std::string(error.what()).find("node 4: no TPDO 2"), std::string::npos) << error.what();
  }
}

/// What `open` says with these drives on the bus.
std::string refusal(const config::DriveTable& wanted, const config::DriveTable& there, bool synchronised = true) {
  const Gantry model;
  const TestBus bus;
  Rack rack(there, model, bus, true);
  CanHardware hardware(wanted, model.parameters(), kCanPeriod, bus.open(), kTestTiming, synchronised);
  try {
    hardware.open();
  } catch (const HardwareError& error) {
    return std::string(describe(error.code())).append(": ").append(error.what());
  }
  return "";
}

TEST(CanHardware, WhatIsWrongWithADriveIsSaidByNameBeforeAnythingMoves) {
  const config::DriveTable good = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  config::DriveTable table = good;
  table.drives[2].settings.push_back({{0x6041, 0}, "Statusword", 1, 2});
  const std::string read_only = refusal(table, good);
  EXPECT_NE(read_only.find("drive z, node 3: refuses Statusword = 1: attempt to write a read only object"),
            std::string::npos)
      << read_only;
  table = good;
  table.drives[3].node = 9;
  const std::string absent = refusal(table, good);
  EXPECT_NE(absent.find("node 9: no boot-up message within"), std::string::npos) << absent;
}

/// The standard EDS file with `text` in place of `found`, which it has once.
canopen::EdsFile changed_eds(const std::string& found, const std::string& text) {
  std::ifstream file(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia402.eds");
  std::string eds{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(eds.find(found), std::string::npos);
  return canopen::EdsFile::parse(eds.replace(eds.find(found), found.size(), text), "changed");
}

TEST(CanHardware, ModesAreDemandedThatWillBeUsed) {
  const config::DriveTable good = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
  const std::string modes = "DefaultValue=0x000003A0";
  config::DriveTable there = good;
  there.eds = changed_eds(modes, "DefaultValue=0x20");
  const std::string homes_alone = refusal(good, there);
  EXPECT_NE(homes_alone.find("drive x, node 1: has no mode cyclic synchronous position, expected bit 7 in its "
                             "supported modes, 6502h, which are 32"),
            std::string::npos)
      << homes_alone;
  there.eds = changed_eds(modes, "DefaultValue=0x80");
  EXPECT_EQ(refusal(good, there), "") << "it is synchronised: nobody asks it to home";
  const std::string does_not_home = refusal(good, there, false);
  EXPECT_NE(does_not_home.find("has no mode homing"), std::string::npos) << does_not_home;
  // 6502h may be left out, 1000h may not
  there.eds = changed_eds("[6502]", "[6503]");
  EXPECT_EQ(refusal(good, there), "");
  there.eds = changed_eds("AccessType=ro", "AccessType=wo");
  const std::string unreadable = refusal(good, there);
  EXPECT_EQ(unreadable.find(describe(ErrorCode::configuration)), 0u) << unreadable;
  EXPECT_NE(unreadable.find("object 1000h"), std::string::npos) << unreadable;
}

}  // namespace
}  // namespace mrroc::edp
