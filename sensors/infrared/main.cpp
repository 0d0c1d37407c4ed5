#include "sensors/infrared/infrared_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::InfraredSensor)
