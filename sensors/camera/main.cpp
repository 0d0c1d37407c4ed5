#include "sensors/camera/camera_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::CameraSensor)
