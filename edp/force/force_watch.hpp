#pragma once

#include <optional>

#include "edp/force/force_guard.hpp"
#include "edp/force/force_sensor.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::edp {

/// The force sensor of one robot, if it has one, and the effect of its readings on a motion. The servo's thread;
/// allocates nothing, never throws.
class ForceWatch {
 public:
  /// The state of the robot in the present tick.
  enum class Doing : std::uint8_t {
    resting,    ///< or stopping: every wrench is allowed
    moving,     ///< along a path
    following,  ///< the force
  };

  /// Sets the sensor, which must outlive this object.
  void use(ForceSensor& sensor, const ForceLimits& limits) noexcept;
  bool present() const noexcept { return sensor_ != nullptr; }
  /// The sensor frame in the flange frame. Only where a sensor is present, as the following ones.
  const Pose& mount() const noexcept { return sensor_->mount(); }

  /// Takes the reading of `tick`; `flange` as in ForceSensor::read.
  void read(Tick tick, const Pose* flange) noexcept;
  /// The present reading becomes zero, including in this tick.
  void bias() noexcept;
  /// The tool carries `carried` (centre in the sensor frame), including in this tick.
  void carry(const Load& carried) noexcept;
  /// As read last: in the axes of the sensor frame, about its origin.
  const Wrench& wrench() const noexcept { return reading_.wrench; }

  /// Whether the motion may continue: class `none`, or the non-fatal error to interrupt it with. Once per tick.
  /// `set_point`: of the flange, in the base frame; not used while read() has no measured one.
  ErrorReport check(Doing doing, const Pose& set_point) noexcept;

 private:
  bool farther_in(const Pose& set_point) const noexcept;

  ForceSensor* sensor_ = nullptr;
  ForceGuard guard_{ForceLimits::Zero()};
  WrenchReading reading_;
  Tick tick_ = 0;
  std::optional<Pose> flange_;
  Pose deepest_ = Pose::Identity();  ///< of the set-points at rest since a force limit has been passed
};

}  // namespace mrroc::edp
