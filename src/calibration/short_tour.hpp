#pragma once

#include <vector>

#include "mrroc/robot_model.hpp"

namespace mrroc::calibration {

/// The postures in an order with short ways between them: from `start` on each is followed by the one that is reached
/// first of those left, at the time max_i |dq_i| / v_i with the greatest velocities v of the joints; of equal ones by
/// the first. Then parts of the tour are reversed as long as that shortens it (2-opt; Croes, Operations Research 6,
/// 1958). The same call gives the same order. Any thread; allocates; of n postures n^2 times per pass.
std::vector<JointVector> short_tour(const RobotModel& model, const JointVector& start,
                                    std::vector<JointVector> postures);

}  // namespace mrroc::calibration
