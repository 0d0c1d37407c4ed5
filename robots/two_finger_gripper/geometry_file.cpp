#include "robots/two_finger_gripper/geometry_file.hpp"

#include <string>

namespace mrroc::two_finger_gripper {

Geometry read_geometry(const config::Table& table, const AxisParameters& axis) {
  Geometry geometry;
  geometry.opening_at_zero = table.number("opening_at_zero", {0, 1});
  geometry.opening_slope = table.number("opening_slope", {-1, 1});
  geometry.opening_curvature = table.number("opening_curvature", {-1, 1});
  geometry.reach = table.number("reach", {0.001, 10});
  if (geometry.opening_curvature == 0) {
    table.fail("opening_curvature", "0 makes it a straight line", "a number that is not 0");
  }
  const double dead = dead_centre(geometry);
  if (!(dead < axis.motor_min || dead > axis.motor_max)) {
    table.fail("opening_curvature",
               "the transmission has its dead centre at " + std::to_string(dead) + " rad, within the motor's limits",
               "one outside " + std::to_string(axis.motor_min) + " to " + std::to_string(axis.motor_max));
  }
  table.finish();
  return geometry;
}

}  // namespace mrroc::two_finger_gripper
