#include <gtest/gtest.h>

#include "fixture.hpp"
#include "mrroc/robots/serial_parallel.hpp"
#include "robots/common/one_robot_task.hpp"

namespace mrroc::class_test {
namespace {

TEST(SerialParallelClass, UsesItsProcessesRobotAndTheInstalledModel) {
  OneRobotTask process("machine", "serial_parallel");
  SerialParallel machine_of_task(process);
  EXPECT_EQ(machine_of_task.name(), "machine");
  const JointVector home = machine_of_task.parameters().home;
  EXPECT_EQ(machine_of_task.models().front()->flange(home).matrix(), machine().flange(home).matrix());
  EXPECT_THROW(SerialParallel(process, "leg"), NonFatalError);
}

}  // namespace
}  // namespace mrroc::class_test
