#include "edp/shell.hpp"
#include "robots/fast_conveyor/fast_conveyor_model.hpp"

MRROC_EDP(mrroc::load_fast_conveyor)
