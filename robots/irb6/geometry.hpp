#pragma once

#include "mrroc/types.hpp"

namespace mrroc::irb6 {

/// A ball screw that closes a triangle between two arms: the screw is sqrt(squares + cosine cos t - sine sin t) long at
/// arm angle t. Lengths in m, coefficients in m^2.
struct ScrewGeometry {
  double gear = 0;            ///< rad of the motor per m of the screw
  double squares = 0;         ///< l1^2 + l2^2 + l3^2 of the linkage
  double cosine = 0;          ///< coefficient of cos t
  double sine = 0;            ///< coefficient of -sin t
  double synchro_length = 0;  ///< length at synchronisation, m
};

/// Geometry of an arm of the IRb-6's family: `[geometry]` of its file, or one of its `[models]`. Lengths in m, gears in
/// rad of the motor per rad of the driven link. An arm has six axes, or five: then it has no tool roll.
struct Geometry {
  double lower_arm = 0;  ///< shoulder to elbow
  double upper_arm = 0;  ///< elbow to wrist pitch axis
  double wrist = 0;      ///< wrist pitch axis to the flange frame's origin
  double column_gear = 0;
  ScrewGeometry lower_arm_screw;
  ScrewGeometry upper_arm_screw;
  double wrist_pitch_gear = 0;
  double wrist_roll_gear = 0;
  double tool_roll_gear = 0;
  /// Motor positions, rad: of the screws at their synchro_length, of the others at an angle of 0; one per axis.
  JointVector zero;
  Pose tool = Pose::Identity();  ///< tool frame in the flange frame
};

}  // namespace mrroc::irb6
