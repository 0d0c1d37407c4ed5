#pragma once

#include "config/table.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// Rejects a parameter file whose numbers are each in range but inconsistent. For every robot, before anything moves;
/// `file` is the parameter file of `models`. Throws ConfigurationError with its line, the key, the values.
///
/// - Home: its motors are within their limits, and every model has joints for them.
/// - Every motor alone, from home to its limits (a whole turn of the joint where it has none), has joint positions that
///   convert back to the motor positions.
/// - 200 random postures within the limits, the same in every run: their motor positions convert back to the joints.
/// - In all of these the transmission d motors / d joints can be inverted and turns no axis the other way than at home:
///   no dead centre is within the limits.
/// - Every joint limit is within the motors' limits in some posture.
///
/// A few milliseconds. Configuration time only.
void check_models(const RobotModels& models, const config::Table& file);

}  // namespace mrroc::edp
