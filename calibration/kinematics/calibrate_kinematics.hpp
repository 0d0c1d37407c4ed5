#pragma once

#include <mrroc/message.hpp>

namespace mrroc::calibration {

/// A behaviour of the program calibrate_kinematics: looks with `sensor`, a camera on the robot's flange whose readings
/// are in the camera frame, at a marker that does not move, from postures that differ as much as the marker allows;
/// estimates the zeros of the robot's joints, the errors of their gears and, of an arm of six joints, where each axis
/// is on the link before (`fit_hand_eye`), returns, and writes them into the calibration file `into`, an absolute path.
/// Every fifth view is kept out of a first estimate, which must expect it no worse than the model of the type does.
/// Nothing may be in the path of the arm above the marker.
struct CalibrateKinematics {
  FixedText<kNameLength> sensor = {};
  FixedText<255> into = {};
  int marker = -1;         ///< of the camera's dictionary; -1: as deployed
  double marker_size = 0;  ///< m, beside `marker`; 0: as deployed
  int views = 90;
  double reach = 0.12;             ///< rad or m of the last three joints, for the first estimate
  double speed = 0.5;              ///< as JointLine's
  double joint_deviation = 0.001;  ///< rad or m: HandEyePriors::joint
  double arm_deviation = 2e-6;     ///< m: HandEyePriors::position, what remains of an arm as measured
  double link_deviation = 0.0003;  ///< m, and as many rad: HandEyePriors::link_position; 0: links as in the model
  double gear_deviation = 0.0002;  ///< rad: HandEyePriors::gear; 0: gears as in the model
  double residual_bound = 0.002;   ///< rad: largest residual of a view that is accepted
};
MRROC_MESSAGE(CalibrateKinematics, sensor, into, marker, marker_size, views, reach, speed, joint_deviation,
              arm_deviation, link_deviation, gear_deviation, residual_bound)

}  // namespace mrroc::calibration
