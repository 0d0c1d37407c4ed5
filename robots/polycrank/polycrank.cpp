#include "mrroc/robots/polycrank.hpp"

#include "robots/polycrank/polycrank_model.hpp"

namespace mrroc {

Polycrank::Polycrank(Task& task, const std::string& name) : Robot(task, name, "polycrank", load_polycrank) {}

Pose Polycrank::tool_down(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // x as the base, y and z reversed
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

}  // namespace mrroc
