#pragma once

#include "edp/test_robots.hpp"

namespace mrroc::edp {

/// A gantry with switches; the axes synchronise from the last to the first.
class Switched : public Gantry {
 public:
  Switched() {
    for (AxisParameters& axis : parameters_.axes) {
      axis.motor_min = -100;
      axis.motor_max = 100;
      axis.motor_synchro = -15.9;
      axis.synchro_coarse = -15;
      axis.synchro_fine = 3.5;
    }
    parameters_.axes[1].synchro_coarse = 15;  // from the other side
    parameters_.axes[1].synchro_fine = -3.5;
    parameters_.synchro_order = {3, 2, 1, 0};
  }
};

}  // namespace mrroc::edp
