#pragma once

#include "edp/safety/fault.hpp"
#include "edp/safety/limit_switches.hpp"
#include "edp/servo/counters.hpp"
#include "edp/servo/servo_state.hpp"
#include "geometry/desired_state.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::edp {

/// All that the servo knows at the end of a tick, as the comms side sees it.
struct Snapshot {
  Tick tick = 0;
  JointVector joints, velocity, motors, current;  ///< measured
  bool synchronised = false;
  bool drives_home = false;  ///< Hardware::homes
  ServoState state = ServoState::off;
  Fault fault;
  LimitSwitches switches;      ///< on which the axes stand
  std::uint8_t model = 0;      ///< in use: place in the ModelSet
  std::uint32_t orders = 0;    ///< how many DriveOrders have been obeyed
  std::uint32_t epoch = 0;     ///< counts the times the servo left the accepted plan (braked, was switched on or off)
  bool braking = false;        ///< the epoch began by braking for want of a successor
  DesiredState desired;        ///< set-point of `tick`
  DesiredState end;            ///< end of the macrostep or stop under way; `desired` when there is none
  Tick end_tick = 0;           ///< when `end` is reached; `tick` when the robot rests
  std::uint64_t finished = 0;  ///< ticket of the last macrostep that ended or was given up
  Wrench wrench = Wrench::Zero();  ///< axes and origin of the force sensor's frame
  double lost = 0;                 ///< as in RobotState
  Signals inputs, outputs;
  std::uint8_t regulators = 0;      ///< set in use
  std::uint32_t interruptions = 0;  ///< counts the motions that were given up for `interruption`
  ErrorReport interruption;         ///< non-fatal: the robot braked and holds
  ServoCounters counters;

  bool enabled() const noexcept { return state == ServoState::on; }  ///< it follows commands
};

}  // namespace mrroc::edp
