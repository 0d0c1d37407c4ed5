#include "edp/shell.hpp"
#include "robots/two_finger_gripper/two_finger_gripper_model.hpp"

MRROC_EDP(mrroc::load_two_finger_gripper)
