#include "edp/shell.hpp"
#include "robots/serial_parallel/serial_parallel_model.hpp"

MRROC_EDP(mrroc::load_serial_parallel)
