#pragma once

#include "edp/safety/fault.hpp"
#include "edp/safety/limit_switches.hpp"
#include "edp/servo/counters.hpp"
#include "edp/servo/servo_state.hpp"
#include "geometry/desired_state.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::edp {

/// The servo's state at the end of a tick, as the comms side reads it. `wrench` is in the axes and about the origin of
/// the force sensor's frame.
struct Snapshot : MeasuredState {
  bool drives_home = false;  ///< Hardware::homes
  ServoState state = ServoState::off;
  Fault fault;
  LimitSwitches switches;      ///< on which the axes stand
  std::uint32_t orders = 0;    ///< how many DriveOrders have been obeyed
  std::uint32_t epoch = 0;     ///< counts how often the servo left the accepted plan (braked, was switched on or off)
  bool braking = false;        ///< the epoch began by braking because no successor came
  bool joined = false;         ///< the epoch began by braking because another robot of the motion had stopped
  std::uint64_t given_up = 0;  ///< CommonStop::group of the motion that was left last
  DesiredState desired;        ///< set-point of `tick`
  DesiredState end;            ///< end of the macrostep or stop under way; `desired` when the robot rests
  Tick end_tick = 0;           ///< when `end` is reached; `tick` when the robot rests
  std::uint64_t finished = 0;  ///< ticket of the last macrostep that ended or was given up
  std::uint32_t interruptions = 0;  ///< counts the motions that were given up for `interruption`
  ErrorReport interruption;         ///< non-fatal: the robot braked and holds
  ServoCounters counters;

  bool enabled() const noexcept { return state == ServoState::on; }  ///< it follows commands
};

}  // namespace mrroc::edp
