#include <gtest/gtest.h>

#include "config/table.hpp"
#include "mrroc/robots/arm.hpp"
#include "robots/arm/arm_fixture.hpp"
#include "robots/common/one_robot_task.hpp"

namespace mrroc {
namespace {

TEST(ArmClass, IsOfTheTypeThatTheDeploymentNames) {
  OneRobotTask process("arm", "bench_arm", kBenchArm);
  Arm arm(process);
  EXPECT_EQ(arm.name(), "arm");
  EXPECT_EQ(arm.parameters().type, "bench_arm");
  EXPECT_EQ(arm.models().size(), 2U);
  const Pose home = arm.kinematics().direct(arm.parameters().home);
  const Pose down = Arm::tool_down(home.translation().x(), home.translation().y(), home.translation().z());
  EXPECT_TRUE(home.linear().col(2).isApprox(down.linear().col(2), 1e-6)) << "at home its tool points down";
}

TEST(ArmClass, RefusesARobotThatIsNotInTheDeployment) {
  OneRobotTask process("arm", "bench_arm");
  EXPECT_THROW(Arm{process}, NonFatalError);
}

TEST(ArmClass, RefusesATypeWithoutAChain) {
  OneRobotTask process("arm", "irb6", std::filesystem::path(MRROC_SOURCE_DIR) / "robots/irb6/irb6.toml");
  EXPECT_THROW(Arm{process}, config::ConfigurationError);
}

}  // namespace
}  // namespace mrroc
