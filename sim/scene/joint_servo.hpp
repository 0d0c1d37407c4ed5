#pragma once

#include <array>
#include <vector>

#include "sim/scene/model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The controller inside a robot that regulates on its own, once per physics step of h s. With r, v the set-points of
/// its joints, q their positions, M the robot's mass matrix, c gravity and the forces of its motion:
///
///   tau = M a + c,  a = kp (r - q) + kd (v - dq/dt),  held within +-torque_max,
///
/// as a controller with a model of its robot does. With p = exp(-w h), w the bandwidth, both poles of a free joint are
/// at p: kp = ((1 - p) / h)^2, kd = (1 - p^2) / h, stable at every bandwidth; interface velocity: kp = 0,
/// kd = (1 - p) / h. So the robot is as stiff at its joints as M kp; loads that M does not contain bend it. Between two
/// ticks r moves on with v. The simulation's thread; only the constructor allocates.
class JointServo {
 public:
  explicit JointServo(const mjModel& model);

  /// A joint: its degree of freedom and its index into qpos.
  struct Joint {
    int dof = 0;
    int position = 0;
  };
  /// Torques of `count` joints after `elapsed` s of the tick, for a step of `h` s, N m or N. M (qM) and the bias forces
  /// of `data` are those of the present posture.
  void compute(const mjModel& model, mjData& data, const world::JointDrive& drive, const Joint* joints,
               std::size_t count, double elapsed, double h, std::array<double, kMaxJoints>& torque) noexcept;

 private:
  std::vector<mjtNum> acceleration_, inertial_;  // of all degrees of freedom
};

}  // namespace mrroc::sim
