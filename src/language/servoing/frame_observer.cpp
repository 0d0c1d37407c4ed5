#include "language/servoing/frame_observer.hpp"

#include <algorithm>

#include "geometry/rigid_motion.hpp"

namespace mrroc {

namespace {

constexpr double kBandwidth = 10;        // w, rad/s
constexpr double kBandwidthSteps = 0.2;  // w times the macrostep, at most

}  // namespace

void FrameObserver::start(const MovingFrame& measured) noexcept {
  estimate_ = measured;
  rate_.setZero();
  jerk_.setZero();
}

void FrameObserver::correct(const MovingFrame& measured, double duration) noexcept {
  const double w = std::min(kBandwidth, kBandwidthSteps / duration);
  Twist error;
  error << measured.pose.translation() - estimate_.pose.translation(),
      rotation_vector(measured.pose.linear() * estimate_.pose.linear().transpose());
  const Twist rate = w * w * error + 2 * w * (measured.twist - estimate_.twist);
  jerk_ = (rate - rate_) / duration;
}

MovingFrame FrameObserver::at(double t) const noexcept {
  MovingFrame frame = estimate_;
  const Twist way = t * (estimate_.twist + t * (rate_ / 2 + (t / 6) * jerk_));
  frame.pose.translation() += way.head<3>();
  frame.pose.linear() = orthonormal(exp_rotation(way.tail<3>()) * estimate_.pose.linear());
  frame.twist += t * (rate_ + (0.5 * t) * jerk_);
  return frame;
}

}  // namespace mrroc
