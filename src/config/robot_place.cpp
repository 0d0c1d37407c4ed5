#include "config/robot_place.hpp"

#include "mrroc/errors.hpp"

namespace mrroc::config {

RobotPlace robot_of_process(const Deployment& deployment, const std::string& process) {
  for (std::size_t i = 0; i < deployment.robots.size(); ++i) {
    const RobotEntry& robot = deployment.robots[i];
    if (process == robot.edp_process() || process == robot.drives_process()) return {i, robot};
  }
  throw SystemError(ErrorCode::configuration, "the deployment has no robot for the process " + process);
}

}  // namespace mrroc::config
