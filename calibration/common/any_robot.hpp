#pragma once

#include "config/deployment.hpp"
#include "mrroc/ecp.hpp"
#include "mrroc/robot.hpp"

namespace mrroc::calibration {

/// The robot of an ECP, of whatever type the deployment gives it: a type of robots/, or an arm that is a chain of
/// joints. Task's thread.
class AnyRobot : public Robot {
 public:
  /// Throws NonFatalError, ConfigurationError: as `Robot`.
  explicit AnyRobot(ecp::Task& task);
};

/// Throws NonFatalError when another robot carries this one: its base moves. Task's thread.
void require_fixed_base(ecp::Task& task, const Robot& robot);

/// The sensors of type `type` on the robot of an ECP, in file order; those of no robot with `robot` empty.
std::vector<const config::SensorEntry*> sensors_on(const config::Deployment& deployment, const std::string& robot,
                                                   const std::string& type);

}  // namespace mrroc::calibration
