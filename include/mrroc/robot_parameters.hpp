#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc {

/// How the drives of a robot are commanded (table `[drives]`).
struct DriveParameters {
  enum class Interface : std::uint8_t {
    current,   ///< the EDP regulates: the drives follow the currents of its regulators
    position,  ///< they regulate on their own and follow set-points of the positions
    velocity   ///< they regulate on their own and follow set-points of the velocities; the EDP corrects the positions
  };
  Interface interface = Interface::current;
  /// Hz: of drives that regulate on their own, what the simulated ones have; else the crossover of the regulators that
  /// the framework designs, 0: it designs none
  double bandwidth = 0;
  double position_gain = 0;  ///< 1/s, interface velocity: velocity per rad or m of position error

  bool regulate_themselves() const noexcept { return interface != Interface::current; }
};

/// One axis: a joint, the motor that drives it, its servo regulator and its plant model. Data only, from
/// robots/TYPE/TYPE.toml. Units: rad or m at the joint, rad at the motor shaft. Of drives that regulate on their own a
/// shaft is the joint where the file says nothing else: 1 rad is 1 rad or 1 m, 1 A is 1 N m or 1 N.
struct AxisParameters {
  std::string name;
  // joint limits: apply at every tick, to every source of set-points; infinite positions: the axis rotates endlessly
  double position_min = 0;
  double position_max = 0;
  double velocity_max = 0;
  double acceleration_max = 0;
  double jerk_max = 0;
  // motor
  double motor_min = 0;
  double motor_max = 0;
  double motor_synchro = 0;          ///< shaft position at synchronisation, rad
  double synchro_coarse = 0;         ///< shaft speed onto the synchronisation switch, rad/s, with sign; 0: no switch
  double synchro_fine = 0;           ///< off the switch and to the zero pulse, rad/s, with the opposite sign
  double encoder_increments = 4000;  ///< per shaft revolution
  double current_max = 0;            ///< A
  /// s for which a measured current may stay at current_max or beyond; the default: forever
  double current_max_time = std::numeric_limits<double>::infinity();
  /// rad of the shaft: how far its set-point may move while the measured position does not change at all.
  double stuck_max = std::numeric_limits<double>::infinity();
  /// A: by how much the drive's current may change before a resting shaft moves (static friction).
  double stuck_current = std::numeric_limits<double>::infinity();
  double following_error_max = 0;  ///< rad of the shaft
  /// N m or N at the joint, of drives that regulate on their own; the default: unknown
  double torque_max = std::numeric_limits<double>::infinity();
  /// kg m^2 or kg at the joint, without the motor's: the least and the greatest within the limits; 0: unknown
  double inertia_min = 0, inertia_max = 0;
  // servo regulator (original's algorithm 0, `mrrocpp` 4.1)
  double regulator_a = 0;
  double regulator_b0 = 0;
  double regulator_b1 = 0;
  double regulator_eps = 0;
  double regulator_output_max = 190;
  double regulator_current_gain = 0;  ///< A per unit of regulator output
  double regulator_bandwidth = 0;     ///< Hz: the numbers above are designed for this crossover; 0: they are given
  // plant model of the drive
  double torque_constant = 0;   ///< N m / A
  double rotor_inertia = 0;     ///< kg m^2, at the shaft
  double viscous_friction = 0;  ///< N m s / rad, at the shaft
};

/// Another set of regulators, by name: the robot's axes with other `regulator_*` numbers.
struct RegulatorSet {
  std::string name;
  std::vector<AxisParameters> axes;
};

/// All numbers of one robot type.
struct RobotParameters {
  std::string type;
  std::string edp;  ///< program of the EDP; empty: TYPE_edp
  DriveParameters drives;
  std::vector<AxisParameters> axes;
  std::vector<RegulatorSet> regulators;         ///< the first is "standard": the axes as they are
  JointVector home;                             ///< joint position in which the simulated robot starts
  std::map<std::string, JointVector> postures;  ///< named joint positions for the operator; "home" is always there
  /// Named tool frames in the flange frame, for the operator; "flange", the flange frame itself, is always there.
  std::map<std::string, Pose> tools;
  double load_max = std::numeric_limits<double>::infinity();  ///< kg, on the flange
  std::vector<int> synchro_order;  ///< the axes in the order of their synchronisation; empty: ascending
};

}  // namespace mrroc
