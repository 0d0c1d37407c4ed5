#include "edp/shell.hpp"
#include "robots/conveyor/conveyor_model.hpp"

MRROC_EDP(mrroc::load_conveyor)
