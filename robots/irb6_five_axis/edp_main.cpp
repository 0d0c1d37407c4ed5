#include "edp/shell.hpp"
#include "robots/irb6_five_axis/irb6_five_axis_model.hpp"

MRROC_EDP(mrroc::load_irb6_five_axis)
