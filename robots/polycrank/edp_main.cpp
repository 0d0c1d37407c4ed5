#include "edp/shell.hpp"
#include "robots/polycrank/polycrank_model.hpp"

MRROC_EDP(mrroc::load_polycrank)
