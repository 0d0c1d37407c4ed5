#pragma once

#include "mrroc/types.hpp"

namespace mrroc::serial_parallel {

/// Hinge positions of the three legs, m. In the tripod frame (base) and in the platform frame legs A and C are on the y
/// axis, leg B on the x axis.
struct LegPoints {
  double a = 0;  ///< y
  double b = 0;  ///< x
  double c = 0;  ///< y
};

/// Limits of the legs' angles in their joints at the base, rad. Angles as in tripod.hpp.
struct PassiveLimits {
  double ac_lean_max = 0;            ///< |lean| of legs A and C
  double b_lean_max = 0;             ///< |lean| of leg B
  double b_lean_inner = 0;           ///< |lean| of leg B up to which it may pitch down to b_pitch_min
  double b_pitch_min = 0;            ///< of leg B
  double b_pitch_min_when_lean = 0;  ///< of leg B when it leans more than b_lean_inner
};

/// `[geometry]` of serial_parallel.toml. Lengths in m.
struct Geometry {
  LegPoints base;
  LegPoints platform;
  double platform_to_wrist = 0;  ///< from the platform frame to the wrist's centre, along the platform's z axis
  double wrist_to_flange = 0;    ///< from the wrist's centre to the flange frame, along the flange's z axis
  PassiveLimits limits;
  JointVector gears;             ///< rad of the motor per m of a leg, per rad of a wrist joint; never 0
  JointVector synchro;           ///< joints at synchronisation, m and rad
  Pose tool = Pose::Identity();  ///< tool frame in the flange frame
};

}  // namespace mrroc::serial_parallel
