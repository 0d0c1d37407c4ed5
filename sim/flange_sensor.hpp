#pragma once

#include <string>
#include <vector>

#include "sim/scene/model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The flange of a robot and the load on it, as a sensor in the flange measures them that is calibrated to the robot's
/// own links. The flange is the site of the MJCF sensors `<robot>/force_torque/force` and `.../torque`. With s their
/// wrench, by which the arm supports all bodies behind the site, the load is
///
///     l = -s - g,   g = (sum R^T m_i a, sum r_i x R^T m_i a),
///
/// where m_i, r_i are mass and centre of each body behind the site whose name begins with `<robot>/`, R the flange's
/// orientation and a gravity. l contains the environment's wrench, the weight of what the robot carries, and inertial
/// forces; N and N m, in the axes of the flange and about its origin. The pose is that in the body `<robot>`.
class FlangeSensor {
 public:
  /// Throws config::ConfigurationError when the world has no such MJCF sensors.
  FlangeSensor(const mjModel& model, const std::string& robot);

  /// Writes all but the tick. Allocates nothing, never throws.
  void measure(const mjModel& model, const mjData& data, world::FlangeMeasurement& measurement) const noexcept;

 private:
  int base_ = -1, site_ = -1;
  int force_ = -1, torque_ = -1;  ///< addresses in sensordata
  std::vector<int> bodies_;       ///< the robot's own, behind the flange
};

}  // namespace mrroc::sim
