#include "sensors/operator_input/operator_input_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::OperatorInputSensor)
