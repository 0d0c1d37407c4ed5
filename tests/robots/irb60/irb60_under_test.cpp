#include "robots/irb6/family/robot_under_test.hpp"
#include "robots/irb6/irb6_model.hpp"

const mrroc::RobotUnderTest& mrroc::robot_under_test() {
  static const RobotUnderTest robot{"irb60", load_irb6(robot_file("irb60", "toml"))};
  return robot;
}
