#pragma once

#include <string>
#include <vector>

#include "config/table.hpp"
#include "mrroc/robot_parameters.hpp"
#include "robots/irb6/geometry.hpp"

namespace mrroc::irb6 {

/// One kinematic model of an arm, by the name that deployments and task programs use.
struct NamedGeometry {
  std::string name;
  Geometry geometry;
};

/// Reads axes and home of a parameter file of the family. Throws ConfigurationError, also unless it has `count` axes.
RobotParameters read_parameters(const config::Table& file, int count);

/// Reads the arm's kinematic models: `[geometry]` as "nominal", with the axes' motor_synchro as zeros, then each
/// `[models.<name>]`: its own lengths and screws, `synchro` (motor positions, rad) and the angles `*_offset` (rad)
/// in which its column and rolls are there; gears and tool are the nominal ones. The arm's axes are those from `column`
/// on. Throws ConfigurationError, also for a screw whose length would be zero at some angle or that a motor would take
/// to a dead centre within its limits, and for gears of zero.
std::vector<NamedGeometry> read_models(const config::Table& file, const RobotParameters& parameters, int column = 0);

}  // namespace mrroc::irb6
