#pragma once

#include "mrroc/robot_parameters.hpp"

namespace mrroc::regulation {

/// Inertia at the shaft, kg m2: of the rotor, and of the joint behind `gear` (rad/rad, rad/m).
double shaft_inertia(const AxisParameters& axis, double joint_inertia, double gear) noexcept;

/// The inertia for which an axis' regulator is designed: the geometric mean of the least and the greatest at the shaft,
/// so that the gain of the loop is wrong by the same factor at both.
double design_inertia(const AxisParameters& axis, double gear) noexcept;

/// Puts numbers into the axis' regulator (algorithm 0, edp/servo/regulator.hpp) that give its loop the crossover
/// w = 2 pi regulator_bandwidth. In continuous time the law is a PID with
///   zeros at w/3 (the velocity) and w/10 (the sum), a pole at 8 w, and the gain for which |L(w)| = 1
/// which has a phase margin of 58 degrees less 1.5 w period. `regulator_current_gain` becomes 1 A,
/// `regulator_output_max` current_max. The axis has its inertia, torque constant, rotor inertia, friction, encoder. Any
/// thread; never throws.
void design_regulator(AxisParameters& axis, double gear, double period) noexcept;

}  // namespace mrroc::regulation
