#include <gtest/gtest.h>

#include "mrroc/robots/fast_conveyor.hpp"
#include "robots/common/one_robot_task.hpp"

namespace mrroc {
namespace {

TEST(FastConveyorClass, TakesItsProcessesRobotAndTheInstalledModel) {
  OneRobotTask process("belt", "fast_conveyor");
  FastConveyor belt(process);
  EXPECT_EQ(belt.name(), "belt");
  EXPECT_EQ(belt.parameters().type, "fast_conveyor");
  EXPECT_EQ(belt.kinematics().direct(FastConveyor::at(1.5)).translation(), Eigen::Vector3d(1.5, 0, 0));
}

TEST(FastConveyorClass, IsNoConveyorOfTheOtherType) {
  OneRobotTask process("belt", "conveyor");
  EXPECT_THROW(FastConveyor{process}, NonFatalError);
}

}  // namespace
}  // namespace mrroc
