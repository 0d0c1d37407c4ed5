#pragma once

#include <vector>

#include "edp/servo/encoders.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// The plant model of drives that regulate on their own: each shaft follows its set-point r, which moves with v during
/// a servo period T. With w the bandwidth (rad/s), e = r - x the error of the position and u = v - dx/dt:
///
///   interface position: x'' = w^2 e + 2 w u, exactly e(T) = (e + (u + w e) T) g,  u(T) = (u - w (u + w e) T) g,
///   interface velocity: x'' = w u,           exactly u(T) = u g,  e(T) = e + u (1 - g) / w,   g = exp(-w T),
///
/// with v increased by position_gain e of the last reading. Measured currents are zero. `Encoders` computes positions
/// from the shafts. The robot starts at `home`; disabled, the brakes hold it where it is. Terminals as those of
/// LoopbackHardware. Deterministic.
class RegulatedLoopback : public Hardware {
 public:
  /// `period` in s. Throws SystemError when `home` cannot be reached.
  RegulatedLoopback(const RobotModel& model, double period, bool synchronised = true);

  /// Digital input `terminal` is on from the start. Before the first tick.
  void close(int terminal) noexcept { terminals_.set(terminal, true); }

  void open() override {}
  void enable(bool on) noexcept override;
  bool waits() const noexcept override { return true; }
  void read(Tick tick, HardwareInput& input) noexcept override;
  void set_points(const JointVector& position, const JointVector& velocity) noexcept override;
  void write(Tick, const JointVector&) noexcept override {}
  void set_outputs(const ControllerIo& outputs) noexcept override { terminals_ = outputs; }
  void set_origin(const JointVector& shift) noexcept override { encoders_.set_origin(shift); }

 private:
  struct Motor {
    double angle = 0;     ///< x
    double velocity = 0;  ///< dx/dt
    double target = 0;    ///< r
    double rate = 0;      ///< v
  };
  void step(Motor& motor) const noexcept;

  DriveParameters drives_;
  double period_, rate_, decay_;  ///< T, w, g
  std::vector<Motor> motors_;
  JointVector shafts_;
  Encoders encoders_;
  ControllerIo terminals_;
  Tick last_ = 0;
  bool enabled_ = false;
};

}  // namespace mrroc::edp
