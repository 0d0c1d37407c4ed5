#include "edp/shell.hpp"
#include "robots/irb6_track/irb6_track_model.hpp"

MRROC_EDP(mrroc::load_irb6_track)
