#pragma once

#include <string>
#include <vector>

#include "mrroc/raw_reading.hpp"
#include "sim/scene/model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The MJCF sensors that are the simulated hardware of one sensor of the deployment: the first of these that exists:
///   1. `<name>` and `<name>/...`                   declared in the scene
///   2. `<robot>/<name>` and `<robot>/<name>/...`   declared in the MJCF of the robot that it is mounted on
///   3. `<robot>/<type>` and `<robot>/<type>/...`   the same, for any sensor of this type
/// Its raw values are theirs, one after the other, in the order of declaration; units and frames are MuJoCo's (a
/// rangefinder reads metres, -1 when it detects nothing; force and torque act from the parent on the site's body, in
/// the site's frame).
class SensorSource {
 public:
  /// Throws config::ConfigurationError when there is no such MJCF sensor (it lists those that exist) or they have more
  /// values than a reading carries.
  SensorSource(const mjModel& model, const std::string& name, const std::string& type, const std::string& robot);

  /// Copies the present values. No allocation; never throws.
  void read(const mjData& data, RawReading& reading) const noexcept;

 private:
  bool take(const mjModel& model, const std::string& prefix);
  std::vector<int> addresses_;  ///< into sensordata
};

}  // namespace mrroc::sim
