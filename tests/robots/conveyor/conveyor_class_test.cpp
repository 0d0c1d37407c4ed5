#include <gtest/gtest.h>

#include "mrroc/robots/conveyor.hpp"
#include "robots/common/one_robot_task.hpp"

namespace mrroc {
namespace {

TEST(ConveyorClass, UsesItsProcessesRobotAndTheInstalledModel) {
  OneRobotTask process("belt", "conveyor");
  Conveyor belt(process);
  EXPECT_EQ(belt.name(), "belt");
  EXPECT_EQ(belt.parameters().type, "conveyor");
  EXPECT_EQ(belt.kinematics().direct(Conveyor::at(1.5)).translation(), Eigen::Vector3d(1.5, 0, 0));
}

TEST(ConveyorClass, RefusesANameThatIsNotInTheDeployment) {
  OneRobotTask process("belt", "conveyor");
  EXPECT_THROW(Conveyor(process, "band"), NonFatalError);
}

}  // namespace
}  // namespace mrroc
