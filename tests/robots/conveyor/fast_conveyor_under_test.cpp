#include "robots/conveyor/conveyor_fixture.hpp"

std::string mrroc::conveyor_under_test() { return "fast"; }
