#pragma once

#include <functional>
#include <vector>

#include "cli/robot/import/axis_limits.hpp"
#include "kinematics/chain_model.hpp"

namespace mrroc::cli {

/// The model of an arm whose motors are its axes.
kinematics::ChainModel chain_model_of(const UrdfArm& arm, const std::vector<AxisLimits>& axes);

/// Whether a posture may be home: the arm does not collide there and nearby.
using MayBeHome = std::function<bool(const JointVector&)>;

/// A posture for an arm to start from: within the middle of its limits and far from singularities; with six and more
/// axes the tool (its z axis) points down in front of the base where a posture does, else where it lies in front.
/// `may_be`: asked for the best postures first, up to some hundreds; if it accepts none, the best one is taken. The
/// same arm gives the same posture. Configuration time: some ten milliseconds.
JointVector find_home(const kinematics::ChainModel& model, const std::vector<AxisLimits>& axes,
                      const MayBeHome& may_be);

}  // namespace mrroc::cli
