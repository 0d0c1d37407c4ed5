#pragma once

#include <vector>

#include "kinematics/serial_chain.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::kinematics {

/// The chain of a model's axes as they stand when all joints are at zero, each axis moved beside its place on the link
/// before by `links` (MeasuredArm::links; empty: the model's own chain):
///
///   T(q) = prod_i (p_i - p_(i-1)) D_i exp(a_i q_i) (p_f - p_n),  D_i the small motion of axis i,
///
/// p_i the point of axis i nearest to the flange p_f (of a sliding axis the flange itself), a_i its direction. Throws
/// SystemError(configuration): the model is no chain of its joints, or `links` has another size. Any thread; allocates.
SerialChain measured_chain(const RobotModel& model, const std::vector<Twist>& links = {});

/// Whether a model is the chain of its axes. Any thread; allocates.
bool is_chain(const RobotModel& model);

}  // namespace mrroc::kinematics
