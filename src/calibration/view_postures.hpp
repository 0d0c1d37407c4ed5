#pragma once

#include <vector>

#include "calibration/hand_eye.hpp"

namespace mrroc::calibration {

/// How far the views of a marker differ.
struct ViewCap {
  double tilt = 0.8;         ///< rad, at most
  double turn = 1.5;         ///< rad, about the view
  double nearest = 0.7;      ///< of the first view's distance
  double farthest = 1.6;     ///< of the first view's distance
  double joint_reach = 2.5;  ///< rad or m: how far a joint may be from the first posture
};

/// Postures from which the camera of `rough` sees its marker from many sides: the camera on `cap` around the marker's
/// view from posture `near`, the marker within a tenth of the distance of the picture's middle. At most `count`, in a
/// fixed order; those beyond the limits of joints or motors, or of the cap, are left out, and those with a
/// `beside_posture` beyond them. Any thread; allocates.
std::vector<JointVector> view_postures(const RobotModel& model, const HandEyeFit& rough, const JointVector& near,
                                       std::size_t count, const ViewCap& cap = {});

/// Six postures around `near` for a first estimate: each of the last three joints moved by `reach` to both sides, where
/// the limits allow it.
std::vector<JointVector> first_postures(const RobotModel& model, const JointVector& near, double reach);

/// Where a posture is approached from: from there each joint moves up to it (`approach` 1) or down (-1), so that it is
/// at one side of its play.
JointVector beside_posture(const JointVector& posture, int approach);

/// Whether joints and motors are `kMargin` within their limits.
bool within_limits(const RobotModel& model, const JointVector& joints);

}  // namespace mrroc::calibration
