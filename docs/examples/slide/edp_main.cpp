#include "edp/shell.hpp"
#include "mrroc/robots/slide.hpp"

MRROC_EDP(mrroc::load_slide)
