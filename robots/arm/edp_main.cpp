#include "edp/shell.hpp"
#include "robots/arm/arm_model.hpp"

int main(int argc, char** argv) { return mrroc::edp::run(argc, argv, mrroc::load_arm); }
