#include <gtest/gtest.h>

#include "allocation_counter.hpp"
#include "can_rig.hpp"

namespace mrroc::edp {
namespace {

using test::Counting;

/// All that the servo's thread does with the drives: motion, a drive that restarts and is set up anew, a stop.
TEST(Allocation, TheCyclicPathAllocatesNothing) {
  CanRig<Gantry> rig(canopen::DriveMode::cyclic_position);
  rig.replies.reserve(100);
  ASSERT_TRUE(rig.seen().enabled);
  const RobotCommand motion = relative_joints(JointVector::Constant(4, 0.2), 400);
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  {
    const Counting scope;
    rig.send(motion);
    rig.run(200);
  }
  EXPECT_EQ(allocations, 0u);
  rig.rack.with([](auto& nodes) { nodes[1].boot(0); });
  {
    const Counting scope;
    rig.run(300);
    rig.send(recover);
    rig.run(400);
  }
  EXPECT_EQ(allocations, 0u);
  EXPECT_TRUE(rig.seen().enabled) << describe(rig.seen().fault.code);
  {
    const Counting scope;
    rig.effector.enable(false);
    rig.run(200);
  }
  EXPECT_EQ(allocations, 0u);
}

}  // namespace
}  // namespace mrroc::edp
