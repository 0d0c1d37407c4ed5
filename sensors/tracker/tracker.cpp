#include "mrroc/sensors/tracker.hpp"

namespace mrroc {

Tracker::Tracker(Task& task, const std::string& name) : Sensor(task, name, "tracker") {}

Pose Tracker::pose() const noexcept {
  Pose pose = Pose::Identity();
  pose.translation() << value(0), value(1), value(2);
  pose.linear() = Eigen::Quaterniond(value(3), value(4), value(5), value(6)).toRotationMatrix();
  return pose;
}

}  // namespace mrroc
