#include "sensors/tracker/tracker_sensor.hpp"

#include "geometry/rigid_motion.hpp"
#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"

namespace mrroc::vsp {

void TrackerSensor::configure(const config::SensorEntry& entry, double /*servo_period*/) {
  position_noise_ = number(entry, "position_noise");
  rotation_noise_ = number(entry, "rotation_noise");
  noise_ = Noise{entry.name};
}

void TrackerSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  Eigen::Quaterniond q(r.values[3], r.values[4], r.values[5], r.values[6]);
  if (!(q.norm() > 0.5)) return report(v, ErrorClass::non_fatal, ErrorCode::sensor_not_ready, "the target is not seen");
  Eigen::Vector3d moved, turned;
  for (std::uint32_t i = 0; i < 3; ++i) {
    moved[i] = position_noise_ > 0 ? position_noise_ * noise_.normal(r.tick, i) : 0;
    turned[i] = rotation_noise_ > 0 ? rotation_noise_ * noise_.normal(r.tick, 3 + i) : 0;
  }
  q = (q * Eigen::Quaterniond(exp_rotation(turned))).normalized();
  if (q.w() < 0) q.coeffs() *= -1;
  for (std::size_t i = 0; i < 3; ++i) v.values[i] = r.values[i] + moved[static_cast<Eigen::Index>(i)];
  v.values[3] = q.w(), v.values[4] = q.x(), v.values[5] = q.y(), v.values[6] = q.z();
}

}  // namespace mrroc::vsp
