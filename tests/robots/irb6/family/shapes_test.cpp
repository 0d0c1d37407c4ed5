#include <gtest/gtest.h>

#include "config/table.hpp"
#include "robots/common/mjcf.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

constexpr std::uint64_t kShapeSeed = 20060104;

TEST(Shapes, ArmDoesNotTouchItselfOrItsPost) {
  Mjcf mjcf(robot_file("xml"));
  std::vector<JointVector> postures{robot().parameters().home};
  JointVector synchro;
  ASSERT_EQ(robot().motors_to_joints(per_axis(&AxisParameters::motor_synchro), synchro), ErrorCode::none);
  postures.push_back(synchro);
  std::mt19937_64 random(kShapeSeed);
  for (int i = 0; i < 2000; ++i) postures.push_back(random_posture(random));
  for (const JointVector& posture : postures) {
    mjcf.set_joints(posture);
    mj_forward(mjcf.model.get(), mjcf.data.get());
    ASSERT_EQ(mjcf.data->ncon, 0) << posture.transpose() << ": "
                                  << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom1) << " and "
                                  << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom2);
  }
}

TEST(Shapes, WristSiteIsOnTheBodyThatCarriesTheTool) {
  Mjcf mjcf(robot_file("xml"));
  const int wrist = mj_name2id(mjcf.model.get(), mjOBJ_SITE, "wrist"),
            tool = mj_name2id(mjcf.model.get(), mjOBJ_SITE, "tool");
  const int body = mj_name2id(mjcf.model.get(), mjOBJ_BODY, "tool");
  ASSERT_GE(body, 0);
  EXPECT_EQ(mjcf.model->site_bodyid[wrist], body);
  EXPECT_EQ(mjcf.model->site_bodyid[tool], body);
  EXPECT_EQ(mjcf.model->body_jntnum[body], 0) << "welded, so that the sensor measures all of it";
}

TEST(Shapes, LowestPointOfTheBaseIsTheFloorBelowTheShoulder) {
  Mjcf mjcf(robot_file("xml"));
  mj_kinematics(mjcf.model.get(), mjcf.data.get());
  const int base = mj_name2id(mjcf.model.get(), mjOBJ_BODY, "base");
  double lowest = 0;
  for (int i = 0; i < mjcf.model->ngeom; ++i) {
    if (mjcf.model->geom_bodyid[i] != base || mjcf.model->geom_type[i] != mjGEOM_BOX) continue;
    lowest = std::min(lowest, mjcf.data->geom_xpos[3 * i + 2] - mjcf.model->geom_size[3 * i + 2]);
  }
  const auto description = config::Table::load(robot_file("toml")).table("description");
  EXPECT_NEAR(lowest, -description.number("shoulder_height"), 1e-12);
}

}  // namespace
}  // namespace mrroc
