#include "sensors/tracker/tracker_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::TrackerSensor)
