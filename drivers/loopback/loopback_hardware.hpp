#pragma once

#include <vector>

#include "edp/servo/encoders.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// Drives with their own plant model: per motor, with J the rotor's inertia, b the viscous friction and k_t
/// the torque constant, J dw/dt = k_t i - b w. Within one servo period the current is constant and the solution exact:
///   w' = w_e + (w - w_e) g,  angle' = angle + w_e T + (w - w_e) (1 - g) J/b,  w_e = k_t i / b,  g = exp(-b T / J).
/// `Encoders` computes positions from the shafts. The robot starts at `home`; disabled, the brakes hold it where it is.
/// It lags and overshoots as a drive does: the measured position is not simply the commanded one.
///
/// Its terminals are wired back: input i, digital or analogue, is output i of the tick before; inputs that are
/// closed circuits at the start (`close`) are on until outputs are set for the first time.
///
/// There is no coupling by loads: use the simulator for gravity and contact. Deterministic.
class LoopbackHardware : public Hardware {
 public:
  /// `period` in s. Throws SystemError when an axis has no inertia, friction or encoder, or `home` cannot be reached.
  LoopbackHardware(const RobotModel& model, double period, bool synchronised = true);

  /// Digital input `terminal` is on from the start. Before the first tick.
  void close(int terminal) noexcept { terminals_.set(terminal, true); }

  void open() override {}
  void enable(bool on) noexcept override;
  /// A plant model has the servo's time.
  bool waits() const noexcept override { return true; }
  bool follows_current() const noexcept override { return true; }
  void read(Tick tick, HardwareInput& input) noexcept override;
  void write(Tick tick, const JointVector& current) noexcept override;
  void set_outputs(const ControllerIo& outputs) noexcept override { terminals_ = outputs; }
  void set_origin(const JointVector& shift) noexcept override { encoders_.set_origin(shift); }

 private:
  struct Motor {
    double decay;             ///< g
    double final_per_ampere;  ///< k_t / b
    double time_constant;     ///< J / b
    double current_max;
    double angle = 0;
    double velocity = 0;
    double current = 0;
  };
  std::vector<Motor> motors_;
  JointVector shafts_;
  Encoders encoders_;
  ControllerIo terminals_;
  double period_;
  Tick last_ = 0;
  bool enabled_ = false;
};

}  // namespace mrroc::edp
