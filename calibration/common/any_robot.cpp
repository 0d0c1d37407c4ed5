#include "calibration/common/any_robot.hpp"

#include "calibration/common/load_models.hpp"

namespace mrroc::calibration {

namespace {

RobotModels models_of(const ecp::Task& task) {
  const config::RobotEntry& entry = task.process().deployment().robot(task.robot_name(""));
  return load_models(entry.type, entry.files().parameters);
}

}  // namespace

AnyRobot::AnyRobot(ecp::Task& task) : Robot(task, "", models_of(task)) {}

void require_fixed_base(ecp::Task& task, const Robot& robot) {
  const std::string& carrier = task.process().deployment().robot(robot.name()).mount;
  if (!carrier.empty())
    throw NonFatalError(ErrorCode::invalid_argument,
                        "robot '" + robot.name() + "' is carried by '" + carrier + "': its base moves");
}

std::vector<const config::SensorEntry*> sensors_on(const config::Deployment& deployment, const std::string& robot,
                                                   const std::string& type) {
  std::vector<const config::SensorEntry*> found;
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (sensor.type == type && sensor.robot == robot) found.push_back(&sensor);
  return found;
}

}  // namespace mrroc::calibration
