#pragma once

#include "language/desired_state.hpp"

namespace mrroc::edp {

using mrroc::DesiredState;

}  // namespace mrroc::edp
