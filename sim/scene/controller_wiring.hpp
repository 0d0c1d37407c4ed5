#pragma once

#include <array>
#include <string>

#include "mrroc/signals.hpp"
#include "sim/scene/model.hpp"

namespace mrroc::sim {

/// The terminals of one robot's controller, wired to things of the world by name, in its own MJCF or in the scene's:
///
///   sensor    <robot>/input_<i>          digital input i is on while its first value is above 0
///   sensor    <robot>/analog_input_<i>   analogue input i is its first value
///   actuator  <robot>/output_<i>         its control is the upper end of its ctrlrange while digital output i is
///                                        on, the lower end else (1 and 0 without a range)
///   actuator  <robot>/analog_output_<i>  its control is analogue output i
///
/// Missing elements are not wired. The simulation's thread; allocates nothing, never throws.
class ControllerWiring {
 public:
  ControllerWiring(const mjModel& model, const std::string& robot);

  ControllerIo read(const mjData& data) const noexcept;
  void write(const mjModel& model, mjData& data, const ControllerIo& outputs) const noexcept;

 private:
  std::array<int, ControllerIo::kDigital> inputs_{};  ///< address in sensordata; -1: not wired
  std::array<int, ControllerIo::kAnalog> analog_inputs_{};
  std::array<int, ControllerIo::kDigital> outputs_{};  ///< actuator; -1: not wired
  std::array<int, ControllerIo::kAnalog> analog_outputs_{};
};

}  // namespace mrroc::sim
