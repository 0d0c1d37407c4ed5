#include "sensors/force_torque/force_torque_sensor.hpp"

MRROC_WRENCH_SOURCE(mrroc::vsp::ForceTorqueSensor)
