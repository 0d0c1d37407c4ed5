#pragma once

#include "mrroc/robot.hpp"

namespace mrroc {

/// Throws NonFatalError(motor_limit) unless the motors can reach the joints and are within their limits there. `what`
/// begins the text: "target". Task's thread.
void check_motors(const Robot& robot, const JointVector& joints, const std::string& what);

}  // namespace mrroc
