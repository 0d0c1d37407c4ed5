#pragma once

#include <mrroc/message.hpp>

namespace mrroc::calibration {

/// A behaviour of the program calibrate_load: moves the last three joints of the robot around its present posture,
/// reads the wrist sensor `sensor` at rest in each of `postures` orientations, identifies the load behind the sensor
/// and the sensor's zero (`fit_load`), returns, and writes them into the calibration file `into`, an absolute path. The
/// tool must touch nothing.
struct CalibrateLoad {
  FixedText<kNameLength> sensor = {};
  FixedText<255> into = {};
  int postures = 12;           ///< at least kLeastReadings
  double reach = 0.6;          ///< rad or m, of each of the three joints to both sides
  double speed = 0.5;          ///< as JointLine's
  double force_bound = 0.5;    ///< N: largest residual of a posture that is accepted
  double torque_bound = 0.05;  ///< N m
};
MRROC_MESSAGE(CalibrateLoad, sensor, into, postures, reach, speed, force_bound, torque_bound)

}  // namespace mrroc::calibration
