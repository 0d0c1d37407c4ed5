#pragma once

#include <array>
#include <filesystem>
#include <string>

namespace mrroc::ur {

/// Settings of one UR controller. The defaults are those of ur.toml.
struct UrOptions {
  std::string address;         ///< host name or IP address of the controller
  int rtde_port = 30004;       ///< real-time data exchange
  int dashboard_port = 29999;  ///< power, brakes, protective stop
  int script_port = 30002;     ///< secondary interface, which receives the control script

  double frequency = 0;       ///< Hz, of the controller's packages; 0: the greatest, at most one in a servo period
  double timeout = 2;         ///< s, to connect and to get an answer
  double start_timeout = 60;  ///< s, until the robot has power, its brakes are released and the program runs
  double open_timeout = 0;    ///< s, for which `open` tries again: a simulated controller starts at the same time
  /// The controller is a stand-in that takes part in lockstep: each servo tick waits for its package, and the stand-in
  /// for the tick's set-points.
  bool lockstep = false;
  int missed_max = 10;  ///< controller periods without a package; more: the controller is silent
  int registers = 24;   ///< first of the input and output registers, 12 of real numbers and 3 of integers

  std::filesystem::path script;    ///< of the control script; empty: the installed one
  double watchdog = 0.1;           ///< s without set-points, after which the control script stops the robot
  double servo_gain = 300;         ///< of servoj, 100 to 2000
  double servo_lookahead = 0.05;   ///< s, of servoj, 0.03 to 0.2
  double speed_acceleration = 15;  ///< rad/s^2, of speedj
  double stop_acceleration = 10;   ///< rad/s^2, of stopj

  double payload_mass = 0;                   ///< kg, beyond the flange
  std::array<double, 3> payload_centre{};    ///< m, its centre of gravity in the frame of the flange
  int tool_voltage = -1;                     ///< V, of the tool's connector: 0, 12 or 24; -1: unchanged
  int tool_terminals = -1;                   ///< number of the first digital one of the tool; -1: none (terminals.hpp)
  double speed_slider = 0;                   ///< 0.01 to 1; 0: unchanged
  std::array<double, 6> torque_constants{};  ///< N m/A at the joints; 0: the measured currents in A are reported
};

/// Throws std::invalid_argument that names the option, its value and what was expected.
void check(const UrOptions& options);

}  // namespace mrroc::ur
