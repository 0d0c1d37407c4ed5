#pragma once

#include "edp/command/force_target.hpp"
#include "geometry/desired_state.hpp"
#include "language/macrostep/macrostep_path.hpp"
#include "mrroc/common_stop.hpp"
#include "mrroc/load.hpp"
#include "mrroc/signals.hpp"

namespace mrroc::edp {

/// One accepted macrostep, ready for the servo: all its values have been checked. Its tick 0 is the boundary with the
/// motion before (the set-point there is `from`); its set-points are those of ticks 1..steps, the last one is exactly
/// `to`.
struct Macrostep {
  enum class Kind : std::uint8_t {
    path,        ///< along `path`
    force,       ///< `force`, tick by tick: `from` and `to` are not known
    unplanned,   ///< follows a force motion: the servo stops and gives it back, to be planned from there
    stop,        ///< the robot's Stop from `from`, as far as it gets, then rest
    model,       ///< at rest: from its start on the servo uses model `choice`
    regulators,  ///< at rest: from its start on the regulators are those of set `choice`
    bias,        ///< at rest: the present reading of the force sensor becomes zero
    carry,       ///< at rest: the tool carries `load`
    synchronise  ///< as long as it takes; then with the robot's first model
  };
  Kind kind = Kind::path;
  std::uint64_t ticket = 0;      ///< names the command in reports; 0: not commanded, no reply
  std::uint32_t epoch = 0;       ///< the servo's plan that it continues; refused when the servo has left that plan
  Tick start = 0;                ///< tick 0; a resting robot may begin later, a moving one may not
  std::uint32_t steps = 1;       ///< N
  std::uint32_t reply_step = 1;  ///< v, 1..N+1
  DesiredState from;
  DesiredState to;
  MacrostepPath path;
  CommonStop stop;  ///< without a successor; ticks is 0: the robot's Stop
  ForceTarget force;
  Load load;                ///< of `carry`, in the sensor frame
  std::uint8_t choice = 0;  ///< index in the ModelSet or of the regulator set
  bool with_outputs = false;
  ControllerIo outputs;  ///< from its start on, where `with_outputs`
};

}  // namespace mrroc::edp
