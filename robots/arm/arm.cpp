#include "mrroc/robots/arm.hpp"

#include "mrroc/task.hpp"
#include "robots/arm/arm_model.hpp"

namespace mrroc {

namespace {

RobotModels models_of(const Task& task, const std::string& name) {
  const std::filesystem::path file = task.robot_parameters(name, "");
  if (file.empty())
    throw NonFatalError(ErrorCode::invalid_argument, "robot '" + name + "' is not in the deployment",
                        {task.process_name(), name, 0, 0});
  return load_arm(file);
}

}  // namespace

Arm::Arm(Task& task, const std::string& name) : Robot(task, name, models_of(task, task.robot_name(name))) {}

Pose Arm::tool_down(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // x as the base, y and z reversed
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

}  // namespace mrroc
