#pragma once

#include <array>
#include <string>
#include <vector>

#include "mrroc/types.hpp"
#include "sim/scene/joint_servo.hpp"
#include "sim/scene/model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The joints of one robot in the world, and the effect of its drives during one tick:
///
///   (M(q) + B) d2q/dt2 = tau - D dq/dt - c + all that MuJoCo computes,
///
/// with B, D, tau, c of the robot's `world::JointDrive`, constant within a tick. B is added to MuJoCo's sparse inertia
/// matrix before it is factored; D acts implicitly in the integration, as MuJoCo's own joint damping does. Armature and
/// damping that the MJCF gives these joints only scale its constraints (they were used for invweight0): they are set to
/// zero. Drives that regulate on their own add the torques of `JointServo` instead.
///
/// With brakes on, the joints stay where they were when the brakes engaged, under any load: they get an inertia
/// of 1e10, so that contact forces and force sensors see a rigid robot, and their positions are restored after the
/// step.
///
/// A joint in the robot's MJCF tuple "endless" (a conveyor's belt) is put back to zero after every step while its
/// travel is counted, so that the belt's geometry stays in place under the parts that it carries. MJCF sensors
/// `jointpos` of it read the travel.
///
/// The simulation's thread; only the constructor allocates or throws.
class DrivenJoints {
 public:
  /// Joints "<robot>/<name>" of `model`, in the order of `names`. Throws config::ConfigurationError: one is
  /// missing (the message lists the robot's joints) or is neither hinge nor slide.
  DrivenJoints(mjModel& model, const std::string& robot, const std::vector<std::string>& names);

  const std::string& robot() const noexcept { return robot_; }
  std::size_t count() const noexcept { return count_; }
  /// Puts the joints at `position`, at rest; brakes on. Joints that follow one of them by an equality are put where it
  /// requires.
  void place(const mjModel& model, mjData& data, const JointVector& position) noexcept;

  /// Index of the first joint that has a number in `drive` that is not finite; -1: none.
  int find_not_finite(const world::JointDrive& drive) const noexcept;
  /// Whether B and D couple only joints that lie on one kinematic chain (MuJoCo's matrix has no place for others).
  bool couples_one_chain(const world::JointDrive& drive) const noexcept;
  /// Takes the drive of the coming tick; brakes off.
  void drive(mjModel& model, const world::JointDrive& drive) noexcept;
  /// Coulomb friction of the joints, N m or N, until the brakes engage; a constraint of MuJoCo's (dof_frictionloss).
  void set_friction(mjModel& model, const std::array<double, kMaxJoints>& friction) const noexcept;
  /// Brakes on, here and now.
  void brake(mjModel& model, mjData& data) noexcept;
  bool braked() const noexcept { return braked_; }

  // ---- parts of one physics step, in this order
  // ----------------------------------------------------------------------
  /// M += B, after mj_fwdPosition.
  void add_inertia(mjData& data) const noexcept;
  /// qfrc_applied = tau - c - (what of D dq/dt couples joints); its diagonal is MuJoCo's joint damping. `h`: of the
  /// step, s.
  void apply_torque(const mjModel& model, mjData& data, double h) noexcept;
  /// M += h D off its diagonal, which mj_Euler adds itself.
  void add_damping(mjData& data, double h) const noexcept;
  /// After the integration of a step of `h` s: holds braked joints, rolls endless ones back.
  void finish(mjData& data, double h) noexcept;
  /// After mj_sensorPos: replaces its values for endless joints by their travel.
  void add_travel(mjData& data) const noexcept;

  void measure(const mjData& data, world::JointMeasurement& measurement) const noexcept;

 private:
  struct Joint {
    bool endless = false;
    double travel = 0;  ///< of an endless joint
    double held = 0;    ///< position where the brakes engaged
  };
  struct TravelSensor {
    int address;  ///< in sensordata
    std::size_t joint;
  };
  double entry(const std::array<double, kMaxJoints * kMaxJoints>& matrix, std::size_t i, std::size_t j) const noexcept {
    return matrix[i * kMaxJoints + j];
  }
  void find_addresses(const mjModel& model);
  void find_travel_sensors(const mjModel& model);
  void disable_actuators(mjModel& model) const;

  std::string robot_;
  std::size_t count_ = 0;
  std::array<Joint, kMaxJoints> joints_{};
  std::array<JointServo::Joint, kMaxJoints> places_{};
  std::array<int, kMaxJoints * kMaxJoints> addresses_{};  ///< (i, j) in MuJoCo's sparse M; -1: not on one chain
  std::vector<TravelSensor> travel_sensors_;
  world::JointDrive drive_{};
  JointServo servo_;
  double elapsed_ = 0;                       ///< s of the tick
  std::array<double, kMaxJoints> torque_{};  ///< of drives that regulate on their own
  bool braked_ = true;
};

}  // namespace mrroc::sim
