#include "edp/force/force_watch.hpp"

#include <cmath>

#include "edp/safety/error_report.hpp"
#include "language/limits.hpp"

namespace mrroc::edp {

void ForceWatch::use(ForceSensor& sensor, const ForceLimits& limits) noexcept {
  sensor_ = &sensor;
  guard_ = ForceGuard(limits);
}

void ForceWatch::read(Tick tick, const Pose* flange) noexcept {
  tick_ = tick;
  flange_ = flange != nullptr ? std::optional<Pose>(*flange) : std::nullopt;
  reading_ = sensor_->read(tick, flange);
}

void ForceWatch::carry(const Load& carried) noexcept {
  sensor_->carry(carried);
  reading_ = sensor_->read(tick_, flange_ ? &*flange_ : nullptr);
}

void ForceWatch::bias() noexcept {
  sensor_->bias();
  reading_ = sensor_->read(tick_, flange_ ? &*flange_ : nullptr);
}

/// Against the wrench of the contact: W = F . d + M . r < 0, where d and r are what the set-point has gone and turned
/// since the deepest rest, in the axes of the sensor frame and about its origin.
bool ForceWatch::farther_in(const Pose& set_point) const noexcept {
  const Pose from = deepest_ * sensor_->mount(), to = set_point * sensor_->mount();
  const Eigen::Vector3d gone = from.rotation().transpose() * (to.translation() - from.translation());
  const Eigen::AngleAxisd turned(from.rotation().transpose() * to.rotation());
  return reading_.wrench.head<3>().dot(gone) + reading_.wrench.tail<3>().dot(turned.angle() * turned.axis()) < 0;
}

ErrorReport ForceWatch::check(Doing doing, const Pose& set_point) noexcept {
  const bool rests = doing == Doing::resting, farther = !flange_ || !guard_.leaving() || farther_in(set_point);
  const int axis = guard_.check(reading_.wrench, !rests, farther);
  if (rests && farther) deepest_ = set_point;
  if (rests) return {};
  const auto tick = static_cast<unsigned long long>(tick_);
  if (axis >= 0) {
    const double value = reading_.wrench[axis], limit = guard_.limit(axis);
    const int digits = digits_to_differ(std::abs(value), limit);
    return make_report(ErrorClass::non_fatal, ErrorCode::force_limit,
                       "axis %d of the force sensor: %.*g %s at tick %llu, limit %.*g", axis + 1, digits, value,
                       axis < 3 ? "N" : "N m", tick, digits, limit);
  }
  if (reading_.error == ErrorCode::none) return {};
  // the tool's weight is not known before the robot is synchronised
  if (reading_.error == ErrorCode::sensor_not_ready && !flange_) return {};
  // a wrench beyond the sensor's range is known well enough to come out of it, not to follow it
  if (reading_.error == ErrorCode::sensor_out_of_range && doing != Doing::following) return {};
  return make_report(ErrorClass::non_fatal, reading_.error, "the force sensor, at tick %llu", tick);
}

}  // namespace mrroc::edp
