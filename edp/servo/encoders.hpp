#pragma once

#include "edp/hardware.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

/// The position measurement of simulated drives, as the original's cabinets do it: incremental encoders with one zero
/// pulse per revolution, a synchronisation switch and two limit switches per axis.
///
/// Encoders resolve a shaft revolution into encoder_increments. Robots that start unsynchronised count from power-on.
/// With s the axis's motor_synchro and u the direction of its coarse synchronisation motion (+-1), the
/// switch is closed where u (m - s) / 2 pi >= 0.5, up to the limit: so it shows on which side of s an axis
/// is, and the first zero pulse off it, in the direction -u, is at s. (The original's sources do not give the length of
/// its switches; they call it an area.) An axis is on a limit switch as far beyond motor_min and motor_max as it may be
/// from its set-point, following_error_max: commands within the limits never meet one. Deterministic; allocates in the
/// constructor only.
class Encoders {
 public:
  Encoders(const RobotParameters& parameters, bool synchronised);

  /// Fills motors, switches, zero pulses and `synchronised` of `input` for the true shaft positions `shafts`.
  void read(const JointVector& shafts, HardwareInput& input) noexcept;
  /// True shaft positions that are read as `motors`.
  JointVector shafts(const JointVector& motors) const noexcept;
  /// As `Hardware::set_origin`.
  void set_origin(const JointVector& shift) noexcept;

 private:
  struct Axis {
    double increment, synchro, direction, lower, upper;
    double offset = 0;  ///< reported = true + offset
    double previous = 0;
  };
  std::array<Axis, kMaxJoints> axes_{};
  std::size_t count_;
  bool synchronised_;
  bool started_ = false;
};

}  // namespace mrroc::edp
