#pragma once

#include <array>
#include <cstdint>

#include "edp/servo/servo_state.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/signals.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// What the servo read, wanted and gave in one tick. Plain values: it crosses to another process.
struct ServoSample {
  using Values = std::array<double, kMaxJoints>;  ///< of the axes; the rest is undefined

  Tick tick;
  double ahead;     ///< of the tick, of a robot that keeps the time (Servo)
  double measured;  ///< time of `joints`, `motors` and `current`, ticks
  std::uint32_t axes;
  Values joints, velocity;       ///< rad, rad/s or m, m/s; those of the shafts until the drives are synchronised
  Values desired_joints;         ///< the set-point
  Values motors;                 ///< shafts, rad
  Values desired_motors;         ///< the set-point
  Values current;                ///< measured, A
  Values commanded_current;      ///< for the coming period, A
  std::array<double, 6> wrench;  ///< in the axes and about the origin of the force sensor's frame; zero without one
  ControllerIo inputs, outputs;
  ServoState state;
  ErrorCode fault;         ///< latched
  std::int8_t fault_axis;  ///< from 0; -1: the whole robot
};

}  // namespace mrroc::edp
