// The original differed between motor space (MIM) and task space (TCIM); here every space behaves the same.
#include <gtest/gtest.h>

#include <vector>

#include "edp/rig.hpp"

namespace mrroc::edp::interpolation_test {
namespace {

constexpr std::uint16_t kSteps = 400;
const std::vector<CommandKind> kKinds = {CommandKind::joint, CommandKind::motor, CommandKind::pose};
const std::vector<Interpolation> kSpaces = {Interpolation::joints, Interpolation::motors, Interpolation::task};

/// A gantry whose tool is off its yaw axis: straight for the joints is not straight for the tool.
struct OffsetGantry : Rig<Gantry> {
  OffsetGantry() {
    RobotCommand set_tool;
    set_tool.kind = CommandKind::set_tool;
    set_tool.pose = tool;
    if (!send(set_tool))
      while (replies.empty()) Rig::tick();
    replies.clear();
  }
  Pose tool_at(const JointVector& joints) const { return model.flange(joints) * tool; }
  const JointVector& desired() const { return seen().desired.position; }

  const Pose tool{Eigen::Translation3d(0.3, 0, 0)};
};

/// Moves the joints by `increment`, given to the robot as an increment or as the target that it leads to.
RobotCommand by(const OffsetGantry& rig, CommandKind kind, Interpolation space, const JointVector& increment,
                bool relative) {
  const JointVector target = rig.desired() + increment;
  RobotCommand command = joint_command(relative ? increment : target, kSteps, kSteps);
  command.kind = kind;
  command.interpolation = space;
  command.relative = relative;
  if (kind == CommandKind::motor) command.joints *= GearedModel::kGear;
  if (kind == CommandKind::pose) {
    command.pose = rig.tool_at(target);
    if (relative) command.pose = rig.tool_at(rig.desired()).inverse() * command.pose;
  }
  return command;
}

const JointVector kIncrement = (JointVector(4) << 0.08, -0.06, 0.04, 0.1).finished();

// original's defect 5: in task space a v out of range was accepted, and never released the caller
TEST(InEverySpace, TheReplyStepIsCheckedAndKept) {
  for (const CommandKind kind : kKinds) {
    for (const Interpolation space : kSpaces) {
      OffsetGantry rig;
      RobotCommand command = by(rig, kind, space, kIncrement, false);
      for (const int wrong : {0, kSteps + 2, 65535}) {
        command.reply_step = static_cast<std::uint16_t>(wrong);
        ASSERT_TRUE(rig.send(command)) << wrong;
        EXPECT_EQ(rig.answer.state.error.code, ErrorCode::invalid_reply_step) << wrong;
      }
      for (const int v : {1, kSteps - 1, kSteps + 0, kSteps + 1}) {
        OffsetGantry fresh;
        command.reply_step = static_cast<std::uint16_t>(v);
        ASSERT_FALSE(fresh.send(command)) << fresh.answer.state.error.detail.view();
        const Tick sent = fresh.seen().tick;
        fresh.run(2 * kSteps);
        ASSERT_EQ(fresh.replies.size(), 1u);
        EXPECT_EQ(fresh.replies[0].state.tick, sent + static_cast<Tick>(v));
      }
    }
  }
}

// original's defect 6: an increment was added to what was measured, or desired, depending on the space
TEST(InEverySpace, RelativeIsRelativeToTheDesiredState) {
  for (const CommandKind kind : kKinds) {
    for (const Interpolation space : kSpaces) {
      OffsetGantry rig;
      const JointVector start = rig.desired();
      ASSERT_FALSE(rig.send(by(rig, kind, space, kIncrement, true))) << rig.answer.state.error.detail.view();
      rig.run(kSteps);
      EXPECT_GT((rig.seen().joints - rig.desired()).norm(), 1e-6) << "otherwise the two cannot be distinguished";
      ASSERT_FALSE(rig.send(by(rig, kind, space, kIncrement, true))) << rig.answer.state.error.detail.view();
      rig.run(kSteps);
      EXPECT_LT((rig.desired() - start - 2 * kIncrement).norm(), 1e-12);
    }
  }
}

// original's defect 27: increments went straight in task space, the same poses given as targets in motor space
TEST(InEverySpace, RelativeAndAbsoluteFollowTheSamePath) {
  for (const CommandKind kind : kKinds) {
    std::vector<JointVector> middles;
    for (const Interpolation space : kSpaces) {
      OffsetGantry absolute, relative;
      ASSERT_FALSE(absolute.send(by(absolute, kind, space, kIncrement, false)));
      ASSERT_FALSE(relative.send(by(relative, kind, space, kIncrement, true)));
      for (int i = 0; i < kSteps; ++i) {
        absolute.tick();
        relative.tick();
        ASSERT_LT((absolute.desired() - relative.desired()).norm(), 1e-12) << i;
        if (i == kSteps / 4) middles.push_back(absolute.desired());
      }
    }
    EXPECT_GT((middles[0] - middles[2]).norm(), 1e-4) << "joint space and task space have different paths";
  }
}

}  // namespace
}  // namespace mrroc::edp::interpolation_test
