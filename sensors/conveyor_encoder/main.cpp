#include "sensors/conveyor_encoder/conveyor_encoder_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::ConveyorEncoderSensor)
