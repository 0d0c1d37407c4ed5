#include "mrroc/robots/serial_parallel.hpp"

#include "robots/serial_parallel/serial_parallel_model.hpp"

namespace mrroc {

SerialParallel::SerialParallel(Task& task, const std::string& name)
    : Robot(task, name, "serial_parallel", load_serial_parallel) {}

Pose SerialParallel::tool_down(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // x as the base, y and z reversed
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

}  // namespace mrroc
