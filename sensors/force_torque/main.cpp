#include "sensors/force_torque/force_torque_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::ForceTorqueSensor)
