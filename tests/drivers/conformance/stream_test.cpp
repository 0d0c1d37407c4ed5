#include "robots/irb6/irb6_model.hpp"
#include "stream_stand_in.hpp"

MRROC_DRIVER_TEST(mrroc::driver_test::StreamStandIn, mrroc::load_irb6)
