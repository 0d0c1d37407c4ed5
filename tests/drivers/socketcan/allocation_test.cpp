#include <gtest/gtest.h>

#include "allocations.hpp"
#include "edp/check/switched_gantry.hpp"
#include "io_rig.hpp"

namespace mrroc::edp {
namespace {

using test::Counting;

using canopen::DriveMode;

class Allocation : public testing::TestWithParam<DriveMode> {};

/// All work of the servo's thread with the drives: motion, an EMCY, a drive that restarts and is set up again, a stop.
TEST_P(Allocation, CyclicPathDoesNotAllocate) {
  CanRig<Gantry> rig(GetParam());
  rig.replies.reserve(100);
  ASSERT_TRUE(rig.seen().enabled());
  const RobotCommand motion = relative_joints(JointVector::Constant(4, 0.2), 400);
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  {
    const Counting scope;
    rig.send(motion);
    rig.run(200);
  }
  EXPECT_EQ(Counting::counted(), 0u);
  rig.rack.with([](auto& nodes) { nodes[2].fail(0x7305); });
  {
    const Counting scope;
    rig.run(200);
    EXPECT_EQ(rig.seen().fault.code, ErrorCode::drive_fault);
    rig.send(recover);
    rig.run(200);
  }
  EXPECT_EQ(Counting::counted(), 0u);
  EXPECT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
  rig.rack.with([](auto& nodes) { nodes[1].boot(0); });
  {
    const Counting scope;
    rig.run(300);
    rig.send(recover);
    rig.run(400);
  }
  EXPECT_EQ(Counting::counted(), 0u);
  EXPECT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
  {
    const Counting scope;
    rig.effector.enable(false);
    rig.run(200);
  }
  EXPECT_EQ(Counting::counted(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Can, Allocation,
                         testing::Values(DriveMode::cyclic_position, DriveMode::cyclic_velocity,
                                         DriveMode::cyclic_torque),
                         [](const auto& each) {
                           return std::string(each.param == DriveMode::cyclic_position   ? "Position"
                                              : each.param == DriveMode::cyclic_velocity ? "Velocity"
                                                                                         : "Torque");
                         });

/// Its axes start beside their switches.
class BesideSwitches : public Switched {
 public:
  BesideSwitches() { parameters_.home = JointVector::Constant(4, 0.05); }
};

TEST(AllocationOfHoming, HomingDoesNotAllocate) {
  CanRig<BesideSwitches> rig(DriveMode::cyclic_position, false);
  rig.replies.reserve(100);
  ASSERT_TRUE(rig.seen().enabled());
  RobotCommand synchronise;
  synchronise.kind = CommandKind::synchronise;
  {
    const Counting scope;
    EXPECT_FALSE(rig.send(synchronise));
    while (rig.replies.empty() && rig.now < 60'000) rig.tick();
  }
  EXPECT_EQ(Counting::counted(), 0u);
  EXPECT_TRUE(rig.seen().synchronised);
}

/// Changing outputs, a node that is lost, restarts and is set up again.
TEST(AllocationOfIo, IoNodesDoNotAllocate) {
  IoRig rig;
  rig.replies.reserve(100);
  ASSERT_TRUE(rig.seen().enabled());
  RobotCommand set_outputs, recover;
  set_outputs.kind = CommandKind::set_outputs;
  set_outputs.outputs.digital = 0xa5a5;
  set_outputs.outputs.analog.fill(1);
  recover.kind = CommandKind::recover;
  {
    const Counting scope;
    rig.send(set_outputs);
    rig.run(100);
  }
  EXPECT_EQ(Counting::counted(), 0u);
  rig.with_node(0, [](auto& node) { node.cut(true); });
  {
    const Counting scope;
    rig.run(100);
    EXPECT_EQ(rig.seen().fault.code, ErrorCode::io_fault);
  }
  EXPECT_EQ(Counting::counted(), 0u);
  rig.with_node(0, [](auto& node) {
    node.cut(false);
    node.boot(0);
  });
  {
    const Counting scope;
    rig.run(50);
    rig.send(recover);
    rig.run(600);
  }
  EXPECT_EQ(Counting::counted(), 0u);
  EXPECT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
}

}  // namespace
}  // namespace mrroc::edp
