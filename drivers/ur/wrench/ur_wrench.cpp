#include "drivers/ur/wrench/wrench_source.hpp"
#include "vsp/driver.hpp"

MRROC_SENSOR_DRIVER(mrroc::ur::open_ur_wrench)
