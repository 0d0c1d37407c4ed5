#pragma once

#include "mrroc/measured_arm.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::kinematics {

/// The same robots as measured. Joints q are those of the encoders with their zeros and gears (`MeasuredJoints`), in
/// every model:
///
///   motors(q) = m(e(q))
///
/// The poses of the first model are those of the measured chain (`measured_chain`); its inverse starts at the postures
/// of the type's own and improves them on that chain. Other models keep the type's poses. Throws
/// SystemError(configuration): numbers of zeros, gears or links that are not those of the axes, or links of a robot
/// whose first model is not a chain of six joints. Configuration time only.
RobotModels with_measured(RobotModels models, const MeasuredArm& measured);

}  // namespace mrroc::kinematics
