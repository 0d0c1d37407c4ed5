#pragma once

#include "kinematics/serial_chain.hpp"

namespace mrroc::kinematics {

/// The displacement from one pose to another: position in base axes, and the rotation vector in base axes.
Twist displacement(const Pose& from, const Pose& to) noexcept;

/// Ranges of the joints, for searches within limits.
struct JointRange {
  JointVector min, max;
};

/// Damped least squares after Levenberg and Marquardt for q: flange(q) = target, from the value of `joints`; with
/// `range` the steps end at its borders. Each step minimises |J dq - e|^2 + mu |dq|^2, so that redundant joints move as
/// little as possible. Returns whether the flange is within `tolerance` (m and rad) of the target after at most
/// `iterations` steps. Any thread; no allocation.
bool improve(const SerialChain& chain, const Pose& target, double tolerance, int iterations, JointVector& joints,
             const JointRange* range = nullptr) noexcept;

}  // namespace mrroc::kinematics
