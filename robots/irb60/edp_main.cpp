#include "edp/shell.hpp"
#include "robots/irb60/irb60_model.hpp"

MRROC_EDP(mrroc::load_irb60)
