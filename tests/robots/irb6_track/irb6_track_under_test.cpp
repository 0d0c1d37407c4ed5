#include "robots/irb6/family/robot_under_test.hpp"
#include "robots/irb6_track/irb6_track_model.hpp"

const mrroc::RobotUnderTest& mrroc::robot_under_test() {
  static const RobotUnderTest robot{"irb6_track", load_irb6_track(robot_file("irb6_track", "toml"))};
  return robot;
}
