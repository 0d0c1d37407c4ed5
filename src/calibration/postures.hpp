#pragma once

#include <vector>

#include "mrroc/robot_model.hpp"

namespace mrroc::calibration {

/// The region in which postures of a calibration are chosen: the last joints of a robot around a posture.
struct PostureRegion {
  JointVector centre;  ///< rad or m
  double reach = 0.6;  ///< rad or m, of each of the last three joints to both sides
};

/// `count` postures whose orientations of the flange turn gravity the most in it. Candidates are the grid of five
/// positions of each of the last three joints within `region`, joints and motors kept `kMargin` within their limits;
/// one after the other the candidate is taken that makes the smallest eigenvalue of sum |d|^2 I - d d^T largest, d the
/// direction of gravity in the flange less the mean of those taken (`fit_load`). The first posture is the centre. The
/// same call gives the same postures.
///
/// Throws NonFatalError(invalid_argument): the centre has another number of joints than the robot, `reach` is not above
/// 0, or fewer candidates than `count` are within the limits. Any thread; allocates.
std::vector<JointVector> gravity_postures(const RobotModel& model, const PostureRegion& region, std::size_t count);

/// Distance from the limits of a joint, rad or m.
inline constexpr double kMargin = 0.02;

}  // namespace mrroc::calibration
