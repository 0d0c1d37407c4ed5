#pragma once

#include "edp/force/wrist_sensor.hpp"
#include "generators/simulated_cell.hpp"
#include "sensors/entry.hpp"
#include "sensors/force_torque/force_torque_sensor.hpp"

namespace mrroc::test {

/// A SimulatedCell whose arm has a force sensor in its wrist, read by its EDP core as in a deployment. `keys`: the
/// sensor's keys in TOML, in addition to its position 90 mm beyond the flange.
class ForceCell : public SimulatedCell {
 public:
  /// The sensor compensates the weight of the IRb-6's own tool.
  static constexpr const char* kToolTakenOut = "tool_mass = 1.1\ntool_centre = [0.004, 0.0, 0.066]\n";

  explicit ForceCell(const std::string& scene, const std::string& keys = kToolTakenOut)
      : SimulatedCell(
            scene, {}, [keys](const config::Deployment& deployment, std::size_t slot, const world::WorldMemory& world) {
              const config::SensorEntry entry =
                  vsp::entry_of("force_torque", "wrist", "position = [0.0, 0.0, 0.09]\n" + keys);
              return std::make_unique<edp::WristSensor>(std::make_unique<vsp::ForceTorqueSensor>(),
                                                        vsp::SourceContext{deployment, entry, slot, &world, kPeriod});
            }) {}
};

}  // namespace mrroc::test
