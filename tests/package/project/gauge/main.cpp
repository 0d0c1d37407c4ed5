#include <vsp/shell.hpp>

#include "gauge_sensor.hpp"

MRROC_VSP(mrroc::vsp::GaugeSensor)
