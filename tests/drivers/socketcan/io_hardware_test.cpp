// The terminals of a robot on a CAN bus: its driver against simulated I/O nodes, whose outputs return as inputs.
#include <gtest/gtest.h>

#include <random>

#include "io_rig.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

constexpr double kCount = 20.0 / 32767;  // of the coarsest range

ControllerIo random_outputs(std::mt19937& random) {
  ControllerIo outputs;
  outputs.digital = static_cast<std::uint16_t>(random());
  for (double& value : outputs.analog) value = std::uniform_real_distribution(-10.0, 10.0)(random);
  return outputs;
}

void expect_equal(const ControllerIo& found, const ControllerIo& expected) {
  EXPECT_EQ(found.digital, expected.digital);
  for (std::size_t i = 0; i < found.analog.size(); ++i) EXPECT_NEAR(found.analog[i], expected.analog[i], kCount) << i;
}

TEST(CanIo, RandomOutputsReturnAsInputsInMotion) {
  IoRig rig;
  ASSERT_TRUE(rig.seen().enabled()) << rig.text();
  std::mt19937 random(1);
  ASSERT_FALSE(rig.send(relative_joints(JointVector::Constant(4, 0.4), 1500)));
  for (int i = 0; i < 50; ++i) {
    const ControllerIo outputs = random_outputs(random);
    rig.put_out(outputs);
    rig.run(kSettled);
    expect_equal(rig.physical(), outputs);
    expect_equal(rig.seen().inputs, outputs);
  }
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none) << rig.text();
}

struct IoCase {
  const char* name;
  std::function<void(sim::IoNode&)> begin, end;
  const char* text;
};

class IoNodeFault : public testing::TestWithParam<IoCase> {};

TEST_P(IoNodeFault, StopsTheRobotInItsLimitsAndIsRecovered) {
  IoRig rig;
  ASSERT_TRUE(rig.seen().enabled()) << rig.text();
  ControllerIo outputs;
  outputs.digital = 0x4801;
  outputs.analog[3] = 2;
  rig.put_out(outputs);
  ASSERT_FALSE(rig.send(relative_joints(JointVector::Constant(4, 0.6), 1500)));
  rig.run(400);
  ASSERT_GT(rig.seen().joint_velocity.norm(), 0.1) << "the robot is moving";
  rig.with_node(0, GetParam().begin);
  double worst = 0;
  for (int i = 0; i < 600 && (rig.seen().fault.code == ErrorCode::none || rig.servo.drives_on()); ++i) {
    rig.tick();
    for (Eigen::Index k = 0; k < 4; ++k)
      worst = std::max(worst, std::abs(rig.seen().desired.velocity[k]) /
                                  rig.model.parameters().axes[static_cast<std::size_t>(k)].velocity_max);
  }
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::io_fault) << describe(rig.seen().fault.code);
  EXPECT_NE(rig.text().find(GetParam().text), std::string::npos) << rig.text();
  EXPECT_FALSE(rig.servo.drives_on());
  EXPECT_LE(worst, 1 + 1e-6);
  EXPECT_LT((rig.rack.shafts() - rig.seen().motors).norm(), 0.1) << "it has stopped on its path";
  rig.run(100);
  EXPECT_EQ(rig.recover(), GetParam().end == nullptr ? ErrorCode::none : ErrorCode::io_fault) << rig.text();
  if (GetParam().end != nullptr) {
    rig.with_node(0, GetParam().end);
    rig.run(50);
    EXPECT_EQ(rig.recover(), ErrorCode::none) << rig.text();
  }
  EXPECT_TRUE(rig.seen().enabled());
  rig.run(kSettled);
  expect_equal(rig.physical(), outputs);
  expect_equal(rig.seen().inputs, outputs);
  ASSERT_FALSE(rig.send(relative_joints(JointVector::Constant(4, 0.02), 400)));
  rig.run(500);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none) << rig.text();
}

INSTANTIATE_TEST_SUITE_P(
    Can, IoNodeFault,
    testing::Values(IoCase{"Silent", [](auto& node) { node.cut(true); }, [](auto& node) { node.cut(false); },
                           "node 40: no TPDO 1, inputs, after more than 12 SYNCs in a row"},
                    IoCase{"WithoutHeartbeat", [](auto& node) { node.hush(true); },
                           [](auto& node) { node.hush(false); }, "node 40: the last heartbeat is 31 ticks old"},
                    IoCase{"Short", [](auto& node) { node.shorten(true); }, [](auto& node) { node.shorten(false); },
                           "node 40: no TPDO 1, inputs"},
                    IoCase{"Restarted", [](auto& node) { node.boot(0); }, nullptr, "node 40 has restarted"},
                    IoCase{"InError", [](auto& node) { node.fail(0x2310); }, [](auto& node) { node.fail(0); },
                           "node 40: error code 2310h"}),
    [](const auto& each) { return each.param.name; });

TEST(CanIo, EmergencyStopOfAnInputStopsTheRobotInMotion) {
  IoRig rig;
  const ControllerIo released = rig.use_emergency_terminal();
  rig.run(5);
  ASSERT_EQ(rig.seen().fault.code, ErrorCode::none) << rig.text();
  ASSERT_FALSE(rig.send(relative_joints(JointVector::Constant(4, 0.6), 1500)));
  rig.run(400);
  rig.put_out({});
  Tick after = 0;
  while (rig.seen().fault.code == ErrorCode::none && after < 100) {
    rig.tick();
    ++after;
  }
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::emergency_stop);
  EXPECT_LE(after, kSettled);
  rig.run(600);
  EXPECT_FALSE(rig.servo.drives_on());
  EXPECT_EQ(rig.recover(), ErrorCode::emergency_stop) << "still pressed";
  rig.hardware.set_outputs(released);
  rig.run(kSettled);
  rig.operators.reset();
  EXPECT_EQ(rig.recover(), ErrorCode::none) << rig.text();
}

TEST(CanIo, EmergencyStopIsPressedWhileItsNodeIsGone) {
  IoRig rig;
  rig.use_emergency_terminal();
  ASSERT_FALSE(rig.send(relative_joints(JointVector::Constant(4, 0.6), 1500)));
  rig.run(400);
  rig.with_node(1, [](auto& node) { node.cut(true); });
  rig.run(600);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::io_fault);
  EXPECT_FALSE(rig.servo.drives_on());
  rig.with_node(1, [](auto& node) { node.cut(false); });
  rig.run(50);
  EXPECT_EQ(rig.recover(), ErrorCode::emergency_stop) << "it has to be reset, too";
  rig.run(kSettled);
  rig.operators.reset();
  EXPECT_EQ(rig.recover(), ErrorCode::none) << rig.text();
}

TEST(CanIo, OutputThatNoNodeHasIsAFault) {
  config::IoTable io = io_table();
  io.nodes.pop_back();
  IoRig rig(io);
  ControllerIo outputs;
  outputs.set(12, true);
  rig.put_out(outputs);
  rig.run(3);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::io_fault);
  EXPECT_NE(rig.text().find("no node has digital output 12, which is switched on"), std::string::npos) << rig.text();
  outputs = {};
  outputs.analog[2] = 1;
  EXPECT_EQ(rig.recover(), ErrorCode::none);
  rig.put_out(outputs);
  rig.run(3);
  EXPECT_NE(rig.text().find("no node has analogue output 2, which is switched on"), std::string::npos) << rig.text();
}

TEST(CanIo, OutputsTakeTheirErrorValuesWhenTheirMasterEnds) {
  config::IoTable io = io_table();
  io.nodes[0].settings.push_back({{0x6207, 1}, "0x6207:1", 0x81, 1});
  io.nodes[0].settings.push_back({{0x6206, 2}, "0x6206:2", 0x03, 1});
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true, kCanPeriod, io);
  {
    CanHardware hardware(table, model.parameters(), kCanPeriod, bus.opener(), kTestTiming, true, io);
    hardware.open();
    ControllerIo outputs;
    outputs.digital = 0xffff;
    outputs.analog.fill(5);
    hardware.set_outputs(outputs);
    HardwareInput input;
    for (Tick tick = 0; tick < 10; ++tick) {
      hardware.read(tick, input);
      hardware.set_points(input.motors, JointVector::Zero(4));
      hardware.write(tick, JointVector::Zero(4));
    }
    EXPECT_EQ(input.inputs.digital, 0xffff);
  }
  ControllerIo left;
  for (int i = 0; i < 2000; ++i) {
    rack.with_io([&left](auto& nodes) {
      for (const sim::IoNode& node : nodes) node.drive(left);
    });
    if (left.digital == 0x0c81) break;
    ::usleep(1000);
  }
  EXPECT_EQ(left.digital, 0x0c81) << "two outputs keep their state: bits 2 and 3 of the second block";
  EXPECT_EQ(left.analog, ControllerIo{}.analog);
}

/// The error of `open`; empty: none.
std::string refusal(const config::IoTable& wanted, const config::IoTable& there,
                    CanHardware::Timing timing = kTestTiming) {
  const Gantry model;
  const config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  const TestBus bus;
  Rack rack(table, model, bus, true, kCanPeriod, there);
  CanHardware hardware(table, model.parameters(), kCanPeriod, bus.opener(), timing, true, wanted);
  try {
    hardware.open();
  } catch (const HardwareError& error) {
    return std::string(describe(error.code())).append(": ").append(error.detail());
  }
  return "";
}

canopen::EdsFile io_eds_with(const std::string& found, const std::string& text) {
  std::ifstream file(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia401.eds");
  std::string eds{std::istreambuf_iterator<char>(file), {}};
  if (eds.find(found) == std::string::npos) throw std::invalid_argument(found);
  return canopen::EdsFile::parse(eds.replace(eds.find(found), found.size(), text), "changed");
}

TEST(CanIoStart, RefusesAnotherDevice) {
  config::IoTable there = io_table();
  there.nodes[1].eds = io_eds_with("0x000F0191", "0x00020192");
  EXPECT_EQ(refusal(io_table(), there),
            "the configuration is wrong: I/O, node 41: profile 402 in its device type, expected 401, an I/O node");
}

TEST(CanIoStart, RefusesANodeWithTooFewTerminals) {
  const std::string count =
      "[6000sub0]\nParameterName=Highest sub-index supported\nObjectType=0x7\nDataType=0x0005\n"
      "AccessType=ro\nDefaultValue=";
  config::IoTable there = io_table();
  there.nodes[0].eds = io_eds_with(count + "2", count + "1");
  EXPECT_EQ(refusal(io_table(), there),
            "the configuration is wrong: I/O, node 40: has 1 blocks of 8 digital inputs (6000h), expected 2");
}

TEST(CanIoStart, NamesTheSettingThatANodeRefuses) {
  config::IoTable wanted = io_table();
  wanted.nodes[0].settings.push_back({{0x2000, 0}, "0x2000", 1, 1});
  const std::string text = refusal(wanted, io_table());
  EXPECT_TRUE(text.starts_with("the configuration is wrong: I/O, node 40: refuses 0x2000 = 1: ")) << text;
}

TEST(CanIoStart, MissingNodeIsSilent) {
  config::IoTable there = io_table();
  there.nodes.pop_back();
  const std::string text = refusal(io_table(), there, kShortBoot);
  EXPECT_TRUE(text.starts_with("the hardware does not answer: I/O, node 41: no boot-up message within 2 s")) << text;
}

}  // namespace
}  // namespace mrroc::edp
