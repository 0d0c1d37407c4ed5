#include <gtest/gtest.h>

#include <iostream>

#include "robots/common/mjcf.hpp"
#include "robots/common/synchronisation_way.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

constexpr std::uint64_t kSwitchSeed = 20060107;

// motors 2 to 4 turn absolute angles: while one moves, the joints after it turn too
TEST(SynchronisationLaw, ReachesNoStopAndNoSelfContactFromAnyPosture) {
  Mjcf mjcf(robot_file("xml"));
  std::mt19937_64 random(kSwitchSeed);
  std::vector<JointVector> starts{robot().parameters().home};
  for (int i = 0; i < 200; ++i) starts.push_back(random_posture(random));
  JointVector beyond = JointVector::Zero(robot().joint_count());
  for (const JointVector& start : starts) {
    const std::vector<JointVector> way = synchronisation_way(robot(), start, 10);
    ASSERT_FALSE(way.empty());
    for (const JointVector& shafts : way) {
      JointVector joints;
      ASSERT_EQ(robot().motors_to_joints(shafts, joints), ErrorCode::none) << start.transpose();
      beyond = beyond.cwiseMax(joints - per_axis(&AxisParameters::position_max))
                   .cwiseMax(per_axis(&AxisParameters::position_min) - joints);
      for (int i = 0; i < robot().joint_count(); ++i) {
        ASSERT_GT(joints[i], mjcf.model->jnt_range[2 * i]) << i << " from " << start.transpose();
        ASSERT_LT(joints[i], mjcf.model->jnt_range[2 * i + 1]) << i << " from " << start.transpose();
      }
      mjcf.set_joints(joints);
      mj_forward(mjcf.model.get(), mjcf.data.get());
      ASSERT_EQ(mjcf.data->ncon, 0) << joints.transpose() << " from " << start.transpose() << ": "
                                    << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom1) << " and "
                                    << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom2);
    }
  }
  std::cout << "seed " << kSwitchSeed << ": beyond the joint limits by at most " << beyond.transpose() << "\n";
}

}  // namespace
}  // namespace mrroc
