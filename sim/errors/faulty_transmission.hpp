#pragma once

#include <array>
#include <string>
#include <vector>

#include "config/entries/errors_entry.hpp"
#include "mrroc/robot_parameters.hpp"
#include "sim/errors/random.hpp"
#include "sim/errors/true_errors.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The transmissions and drives of one robot with their errors, between its EDP and the joints of the world. The EDP
/// computes with the transmission of its parameter file; the world's joints are moved by the true one (`TrueJoint`).
/// With S = diag(slope): torques at the joint are S tau, B and D are S B S and S D S.
///
/// Backlash is a play between link and encoder: when a joint turns back, its encoder moves at twice the link's speed
/// until the play is crossed.
///
/// The largest torque of an axis is torque_max, else k_t i_max sqrt(B_ii / J) (gear ratio from its reflected inertia B
/// and its rotor's J); friction and current noise are shares of it. The simulation's thread; only the constructor
/// allocates.
class FaultyTransmission {
 public:
  FaultyTransmission(const config::ErrorsEntry& errors, const std::string& robot, const RobotParameters& parameters);

  /// Replaces what the joints of the world show by what the encoders report.
  void report(world::JointMeasurement& measurement) noexcept;
  /// Replaces a drive of the EDP by the one that acts in the world in tick `tick`.
  void act(world::JointDrive& drive, Tick tick) const noexcept;
  /// Coulomb friction of the joints under the drive that `act` has made, N m or N.
  std::array<double, kMaxJoints> friction(const world::JointDrive& drive) const noexcept;

 private:
  struct Axis {
    TrueJoint truth;
    double current_torque = 0;  ///< N m at the shaft at current_max
    double rotor_inertia = 0;   ///< kg m^2
    double torque_max = 0;      ///< N m or N at the joint; infinite: unknown
  };
  double torque_limit(const Axis& axis, double reflected_inertia) const noexcept;

  std::vector<Axis> axes_;
  ErrorNumbers noise_;
  double current_noise_;
  std::array<double, kMaxJoints> position_{};  ///< true ones, as last measured
  std::array<double, kMaxJoints> play_{};
  bool measured_ = false;
};

}  // namespace mrroc::sim
