#include "sensors/time/time_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::TimeSensor)
