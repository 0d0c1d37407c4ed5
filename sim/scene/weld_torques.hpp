#pragma once

#include <mujoco/mujoco.h>

#include <vector>

namespace mrroc::sim {

/// Corrects the world's torque sensors where a weld joins bodies. MuJoCo (up to 3.3.0, its issue 2533) takes the
/// constraint forces f of a weld's three rows of orientation for its torque, and its values are wrong by half or
/// more. The rows are those of the vector part of the error e = q1^-1 q0 q_rel, with
///   de/dt = 1/2 s (R1^T w) e,   so that the torque on the first body is   1/2 s R1 (e_0 f + e_v x f),
/// s the weld's torquescale, w the first body's angular velocity relative to the second's, R1 the second's orientation.
/// The motion itself is correct and stays unchanged. The simulation's thread; only the constructor allocates.
class WeldTorques {
 public:
  /// Finds the torque sensors whose body's subtree is welded to bodies outside it.
  explicit WeldTorques(const mjModel& model);

  /// After mj_sensorAcc.
  void correct(const mjModel& model, mjData& data) const noexcept;

 private:
  struct Sensed {
    int site;
    int address;  ///< in sensordata
    int weld;
    double sign;  ///< of the sensor's share of the torque on the weld's first body
  };
  std::vector<Sensed> sensed_;
};

}  // namespace mrroc::sim
