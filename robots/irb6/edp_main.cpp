#include "edp/shell.hpp"
#include "robots/irb6/irb6_model.hpp"

MRROC_EDP(mrroc::load_irb6)
