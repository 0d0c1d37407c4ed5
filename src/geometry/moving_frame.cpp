#include "mrroc/moving_frame.hpp"

#include "geometry/rigid_motion.hpp"

namespace mrroc {

MovingFrame MovingFrame::after(double seconds) const noexcept {
  MovingFrame later = *this;
  later.pose.translation() += seconds * twist.head<3>();
  later.pose.linear() = exp_rotation(seconds * twist.tail<3>()) * pose.linear();
  return later;
}

MovingFrame sliding_frame(const Pose& at_zero, const Eigen::Vector3d& direction, double travel, double speed,
                          Tick tick) noexcept {
  MovingFrame frame;
  frame.pose = at_zero;
  frame.pose.translation() += travel * direction;
  frame.twist.head<3>() = speed * direction;
  frame.tick = tick;
  return frame;
}

}  // namespace mrroc
