#include "robots/irb6/family/robot_under_test.hpp"
#include "robots/irb6_five_axis/irb6_five_axis_model.hpp"

const mrroc::RobotUnderTest& mrroc::robot_under_test() {
  static const RobotUnderTest robot{"irb6_five_axis", load_irb6_five_axis(robot_file("irb6_five_axis", "toml"))};
  return robot;
}
