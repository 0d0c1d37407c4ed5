#include "sensors/digital_input/digital_input_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::DigitalInputSensor)
