#include "sim/scene/controller_wiring.hpp"

namespace mrroc::sim {
namespace {

int sensor_address(const mjModel& model, const std::string& name) {
  const int sensor = mj_name2id(&model, mjOBJ_SENSOR, name.c_str());
  return sensor < 0 ? -1 : model.sensor_adr[sensor];
}

}  // namespace

ControllerWiring::ControllerWiring(const mjModel& model, const std::string& robot) {
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    inputs_[i] = sensor_address(model, robot + "/input_" + std::to_string(i));
    outputs_[i] = mj_name2id(&model, mjOBJ_ACTUATOR, (robot + "/output_" + std::to_string(i)).c_str());
  }
  for (std::size_t i = 0; i < analog_inputs_.size(); ++i) {
    analog_inputs_[i] = sensor_address(model, robot + "/analog_input_" + std::to_string(i));
    analog_outputs_[i] = mj_name2id(&model, mjOBJ_ACTUATOR, (robot + "/analog_output_" + std::to_string(i)).c_str());
  }
}

ControllerIo ControllerWiring::read(const mjData& data) const noexcept {
  ControllerIo inputs;
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    inputs.set(static_cast<int>(i), inputs_[i] >= 0 && data.sensordata[inputs_[i]] > 0);
  for (std::size_t i = 0; i < analog_inputs_.size(); ++i)
    if (analog_inputs_[i] >= 0) inputs.analog[i] = data.sensordata[analog_inputs_[i]];
  return inputs;
}

void ControllerWiring::write(const mjModel& model, mjData& data, const ControllerIo& outputs) const noexcept {
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const int actuator = outputs_[i];
    if (actuator < 0) continue;
    const bool limited = model.actuator_ctrllimited[actuator] != 0;
    const mjtNum off = limited ? model.actuator_ctrlrange[2 * actuator] : 0;
    const mjtNum on = limited ? model.actuator_ctrlrange[2 * actuator + 1] : 1;
    data.ctrl[actuator] = outputs.on(static_cast<int>(i)) ? on : off;
  }
  for (std::size_t i = 0; i < analog_outputs_.size(); ++i)
    if (analog_outputs_[i] >= 0) data.ctrl[analog_outputs_[i]] = outputs.analog[i];
}

}  // namespace mrroc::sim
