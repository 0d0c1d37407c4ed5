#include "sensors/ultrasonic/ultrasonic_sensor.hpp"
#include "vsp/shell.hpp"

MRROC_VSP(mrroc::vsp::UltrasonicSensor)
