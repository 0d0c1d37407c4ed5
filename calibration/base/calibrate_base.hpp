#pragma once

#include <mrroc/message.hpp>

namespace mrroc::calibration {

/// A behaviour of the program calibrate_base: looks as `CalibrateHandEye` does at a marker whose place in the world is
/// given, and estimates its pose Z in the robot's base frame beside the camera's, which need not be known. The base is
/// at W Z^-1 in the world, W the marker's pose there. Writes it into the calibration file `into`, an absolute path.
struct CalibrateBase {
  FixedText<kNameLength> sensor = {};
  FixedText<255> into = {};
  double x = 0, y = 0, z = 0;           ///< m: the marker's middle in the world
  double roll = 0, pitch = 0, yaw = 0;  ///< rad: its axes, x to the right, y up, z out of it
  int marker = -1;                      ///< of the camera's dictionary; -1: as deployed
  double marker_size = 0;               ///< m, beside `marker`; 0: as deployed
  int views = 40;
  double speed = 0.5;          ///< as JointLine's
  double joint_deviation = 0;  ///< rad or m: HandEyePriors::joint; 0: that of the arm's type, or of one as measured
  double arm_deviation = 0;  ///< m: HandEyePriors::position; of its rotation, twice as many rad; 0: as joint_deviation
  double residual_bound = 0.002;  ///< rad: largest residual of a view that is accepted
  double distance_bound = 0.1;    ///< m: largest distance from the deployment's base that is accepted
};
MRROC_MESSAGE(CalibrateBase, sensor, into, x, y, z, roll, pitch, yaw, marker, marker_size, views, speed,
              joint_deviation, arm_deviation, residual_bound, distance_bound)

}  // namespace mrroc::calibration
