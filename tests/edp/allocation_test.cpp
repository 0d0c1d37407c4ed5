#include <gtest/gtest.h>

#include <limits>

#include "allocations.hpp"
#include "edp/force/force_rig.hpp"
#include "edp/servo/group_rig.hpp"

namespace mrroc::edp::allocation_test {
namespace {

using test::Counting;

TEST(Allocation, CounterCountsAllocationAndRelease) {
  void* (*volatile allocate)(std::size_t) = std::malloc;  // volatile: or the compiler drops the pairs
  void* (*volatile make)(std::size_t) = ::operator new;
  {
    const Counting scope;
    std::free(allocate(10));
  }
  EXPECT_EQ(Counting::counted(), 1u);
  {
    const Counting scope;
    ::operator delete(make(10));
  }
  EXPECT_EQ(Counting::counted(), 1u);
}

TEST(Allocation, TheServoTickAndTheCommsSideAllocateNothing) {
  Rig<Gantry> rig;
  rig.replies.reserve(1000);
  RobotCommand hold;
  hold.kind = CommandKind::hold;
  RobotCommand joint = joint_command(JointVector::Constant(4, 0.01), 60, 58);
  joint.relative = true;
  joint.joint_velocity = JointVector::Constant(4, 0.1);
  RobotCommand pose = joint;
  pose.kind = CommandKind::pose;
  pose.pose = Eigen::Translation3d(0.01, 0.01, 0.005);
  pose.twist << 0.1, 0.1, 0.1, 0, 0, 0;
  RobotCommand far = joint_command(JointVector::Constant(4, 9), 60, 58);
  RobotCommand wild = pose;
  wild.twist[0] = std::numeric_limits<double>::quiet_NaN();
  int refused = 0;
  {
    const Counting scope;
    for (int i = 0; i < 20; ++i) {
      for (const RobotCommand* command : {&joint, &pose, &far, &wild, &hold}) {
        refused += rig.send(*command);
        rig.run(i % 2 == 0 ? 58 : 70);  // in time or late
        refused += rig.query().error.error_class != ErrorClass::none;
      }
    }
    rig.send(joint);
    rig.run(30);
    rig.hardware.fault = ErrorCode::drive_fault;
    rig.run(200);
    refused += rig.send(joint);
    rig.hardware.fault = ErrorCode::none;
    rig.effector.enable(true);
    rig.run(10);
  }
  EXPECT_EQ(Counting::counted(), 0u);
  EXPECT_GE(refused, 41);
  EXPECT_GT(rig.replies.size(), 50u);
  EXPECT_GT(rig.seen().counters.stops, 5u);
}

TEST(Allocation, ForceMotionBesideASingularityDoesNotAllocate) {
  ForceRig<Wrist> rig;
  rig.sensor.stiffness = 0;
  RobotCommand command;
  command.kind = CommandKind::force;
  for (int i = 0; i < 6; ++i) command.force.guarded(i);
  command.force.contact(3, -1);
  rig.replies.reserve(1000);
  double lost = 0;
  ErrorCode code = ErrorCode::none;
  {
    const Counting scope;
    for (int i = 0; i < 60 && code == ErrorCode::none; ++i) {
      const RobotState state = rig.exchange(command);
      lost = std::max(lost, state.lost);
      code = state.error.code;
    }
  }
  EXPECT_EQ(Counting::counted(), 0u);
  EXPECT_GT(lost, 0.5);
  EXPECT_EQ(code, ErrorCode::singular);
}

TEST(Allocation, StopsDoNotAllocate) {
  Rig<Gantry> rig;
  rig.model.change().axes[1].current_max_time = 0.02;
  rig.replies.reserve(1000);
  RobotCommand joint = joint_command(JointVector::Constant(4, 0.015), 60, 58);
  joint.relative = true;
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  int what = 0;
  rig.hardware.spoil = [&what](HardwareInput& input) {
    if (what == 1) input.motors[1] = std::numeric_limits<double>::quiet_NaN();
    if (what == 2) input.motors[1] += 50;
    if (what == 3) input.current[1] = 20;
    if (what == 4) input.switches[1].upper_limit = true;
  };
  int accepted = 0, stopped = 0, refused = 0;
  {
    const Counting scope;
    for (int round = 0; round < 20; ++round) {
      accepted += !rig.send(joint);
      rig.run(20);
      what = round % 5;
      if (what == 0) rig.operators.press();
      rig.run(100);
      stopped += !rig.hardware.powered;
      rig.send(recover);
      rig.run(3);
      refused += rig.send(joint);
      what = 0;
      rig.operators.reset();
      rig.send(recover);
      rig.run(100);
    }
  }
  EXPECT_EQ(Counting::counted(), 0u);
  EXPECT_EQ(accepted, 20);
  EXPECT_EQ(stopped, 20);
  EXPECT_GE(refused, 8);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
}

TEST(Allocation, StopsOfAGroupDoNotAllocate) {
  for (const Break fault : {drive_fault, switched_off, force_limit}) {
    Pair pair;
    pair.a.replies.reserve(10);
    pair.b.replies.reserve(10);
    pair.move(kVelocity);
    pair.run(50);
    {
      const Counting scope;
      fault(pair);
      pair.run(300);
    }
    EXPECT_EQ(Counting::counted(), 0u);
    EXPECT_EQ(pair.b.seen().given_up, kStop.group);
    EXPECT_TRUE(pair.b.seen().desired.at_rest());
  }
}

TEST(Allocation, ForceMotionsAndTheirInterruptionsDoNotAllocate) {
  ForceRig<Gantry> rig;
  rig.replies.reserve(1000);
  RobotCommand press = force_command(10);
  press.twist[1] = 0.05;
  const RobotCommand back = joint_command(JointVector::Zero(4), 500, 500);
  int reported = 0;
  {
    const Counting scope;
    for (int i = 0; i < 20; ++i) {
      rig.repeat(press, 30);
      rig.sensor.extra[2] = 200;  // beyond the limit
      reported += rig.repeat(press, 2).error.code == ErrorCode::force_limit;
      rig.sensor.extra[2] = 0;
      rig.run(200);
      rig.exchange(back);
    }
  }
  EXPECT_EQ(Counting::counted(), 0u);
  EXPECT_EQ(rig.seen().interruptions, 20u);
  EXPECT_EQ(reported, 20);
}

}  // namespace
}  // namespace mrroc::edp::allocation_test
