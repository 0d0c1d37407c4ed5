#include "regulation/regulator_design.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "regulation/servo_loop.hpp"

namespace mrroc::regulation {

namespace {

// of the crossover: the ratios of a PID that leaves 58 degrees and bears an inertia of a sixth to ten times the
// design's
constexpr double kVelocityZero = 1.0 / 3, kSumZero = 0.1, kPole = 8;

}  // namespace

double shaft_inertia(const AxisParameters& axis, double joint_inertia, double gear) noexcept {
  return axis.rotor_inertia + joint_inertia / (gear * gear);
}

double design_inertia(const AxisParameters& axis, double gear) noexcept {
  return std::sqrt(shaft_inertia(axis, axis.inertia_min, gear) * shaft_inertia(axis, axis.inertia_max, gear));
}

void design_regulator(AxisParameters& axis, double gear, double period) noexcept {
  const double crossover = 2 * std::numbers::pi * axis.regulator_bandwidth, turn = crossover * period;
  axis.regulator_a = std::exp(-kPole * turn);
  axis.regulator_eps = std::tanh(kSumZero * turn / 2);  // (1 - eps) / (1 + eps) = exp(-turn / 10)
  axis.regulator_b0 = 1;
  axis.regulator_b1 = std::exp(-kVelocityZero * turn);
  axis.regulator_current_gain = 1;
  axis.regulator_output_max = axis.current_max;
  const double size = std::abs(ServoLoop(axis, design_inertia(axis, gear), period).open(crossover));
  axis.regulator_b0 /= size;
  axis.regulator_b1 /= size;
}

}  // namespace mrroc::regulation
