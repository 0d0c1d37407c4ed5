#pragma once

#include <mrroc/message.hpp>

namespace mrroc::calibration {

/// A behaviour of the program calibrate_hand_eye: looks with `camera`, a camera on the robot's flange whose readings
/// are in the camera frame, at a marker that does not move, from postures around the present one, in which it sees it;
/// estimates the camera's pose on the flange and its focal length (`fit_hand_eye`), returns, and writes them into the
/// calibration file `into`, an absolute path. Nothing may be in the path of the arm above the marker. With both
/// deviations 0, an arm of six joints that was not measured is estimated, too, and the pose is that for its model
/// (`as_computed`).
struct CalibrateHandEye {
  FixedText<kNameLength> sensor = {};
  FixedText<255> into = {};
  int marker = -1;         ///< of the camera's dictionary; -1: as deployed
  double marker_size = 0;  ///< m, beside `marker`; 0: as deployed
  int views = 40;
  double reach = 0.12;         ///< rad or m of the last three joints, for the first estimate
  double speed = 0.5;          ///< as JointLine's
  double joint_deviation = 0;  ///< rad or m: HandEyePriors::joint; 0: that of the arm's type, or of one as measured
  double arm_deviation = 0;  ///< m: HandEyePriors::position; of its rotation, twice as many rad; 0: as joint_deviation
  double residual_bound = 0.002;  ///< rad: largest residual of a view that is accepted
};
MRROC_MESSAGE(CalibrateHandEye, sensor, into, marker, marker_size, views, reach, speed, joint_deviation, arm_deviation,
              residual_bound)

}  // namespace mrroc::calibration
