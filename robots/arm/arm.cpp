#include "mrroc/robots/arm.hpp"

#include "geometry/tool_down.hpp"
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

Pose Arm::tool_down(double x, double y, double z) { return mrroc::tool_down(x, y, z); }

}  // namespace mrroc
