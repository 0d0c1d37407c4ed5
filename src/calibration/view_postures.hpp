#pragma once

#include <vector>

#include "calibration/hand_eye.hpp"

namespace mrroc::calibration {

/// Postures from which the camera of `rough` sees its marker from many sides: the camera on a cap around the
/// marker's view from posture `near`, tilted by up to 0.45 rad, turned about its view by up to 0.5 rad, at 1.0 to 1.6
/// of the distance, the marker within a tenth of the distance of the picture's middle. At most `count`, in a fixed
/// order; those beyond the limits of joints or motors, or with a joint farther than 1.5 rad or m from `near`, are left
/// out. Any thread; allocates.
std::vector<JointVector> view_postures(const RobotModel& model, const HandEyeFit& rough, const JointVector& near,
                                       std::size_t count);

/// Six postures around `near` for a first estimate: each of the last three joints moved by `reach` to both sides, where
/// the limits allow it.
std::vector<JointVector> first_postures(const RobotModel& model, const JointVector& near, double reach);

/// Whether joints and motors are `kMargin` within their limits.
bool within_limits(const RobotModel& model, const JointVector& joints);

}  // namespace mrroc::calibration
