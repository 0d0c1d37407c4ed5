#pragma once

#include <array>

#include "edp/hardware.hpp"
#include "edp/servo/synchroniser.hpp"
#include "geometry/desired_state.hpp"

namespace mrroc::edp {

/// Synchronisation by drives that find their positions themselves (CiA 402-2, homing mode), one axis after the other in
/// the robot's `synchro_order`. The set-point of the axis under way is where it is; the others hold.
///
/// The servo's thread; allocates nothing, never throws.
class DriveHoming {
 public:
  using Status = Synchroniser::Status;

  explicit DriveHoming(const RobotParameters& robot) noexcept;

  /// From rest at `shafts`. The first axis starts.
  void start(Hardware& hardware, const JointVector& shafts) noexcept;
  /// One tick: takes the drives' feedback, gives the next set-point of the shafts. `failed`: a drive has given up.
  Status step(Hardware& hardware, const HardwareInput& input, DesiredState& desired) noexcept;

  /// The offset to add to every shaft position; after `done`.
  const JointVector& shift() const noexcept { return shift_; }
  /// The axis being synchronised, or the one that failed.
  int axis() const noexcept { return order_[place_]; }

 private:
  std::array<int, kMaxJoints> order_{};
  std::size_t count_;
  std::size_t place_ = 0;
  DesiredState desired_;
  JointVector shift_;
};

}  // namespace mrroc::edp
