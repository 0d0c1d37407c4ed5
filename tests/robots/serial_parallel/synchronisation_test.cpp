#include <gtest/gtest.h>

#include "robots/common/synchronisation_way.hpp"
#include "robots/serial_parallel/closed_mjcf.hpp"
#include "robots/serial_parallel/fixture.hpp"

namespace mrroc::synchronisation_test {
namespace {

// one leg after the other tilts the platform: from home the tilt is permitted
TEST(SerialParallelSynchronisation, LegsStayWithinTheirJointsAndReachNoStopFromHome) {
  ClosedMjcf mjcf;
  const std::vector<JointVector> way = synchronisation_way(machine(), machine().parameters().home, 5);
  ASSERT_GT(way.size(), 100u);
  for (const JointVector& shafts : way) {
    JointVector joints, back;
    ASSERT_EQ(machine().motors_to_joints(shafts, joints), ErrorCode::none) << shafts.transpose();
    ASSERT_EQ(machine().joints_to_motors(joints, back), ErrorCode::none) << joints.transpose();
    ASSERT_TRUE(mjcf.close(joints)) << joints.transpose();
    for (int i = 0; i < 6; ++i) {
      const int joint = mj_name2id(mjcf.model.get(), mjOBJ_JOINT,
                                   machine().parameters().axes[static_cast<std::size_t>(i)].name.c_str());
      ASSERT_GT(joints[i], mjcf.model->jnt_range[2 * joint]) << i;
      ASSERT_LT(joints[i], mjcf.model->jnt_range[2 * joint + 1]) << i;
    }
    mj_fwdPosition(mjcf.model.get(), mjcf.data.get());
    ASSERT_EQ(mjcf.data->ncon, 0) << joints.transpose();
  }
}

}  // namespace
}  // namespace mrroc::synchronisation_test
