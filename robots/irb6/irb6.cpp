#include "mrroc/robots/irb6.hpp"

#include "robots/irb6/irb6_model.hpp"

namespace mrroc {

Irb6::Irb6(Task& task, const std::string& name) : Robot(task, name, "irb6", load_irb6) {}

Pose Irb6::tool_down(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // x as the base, y and z reversed
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

}  // namespace mrroc
