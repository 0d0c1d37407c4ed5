#pragma once

#include "mrroc/fixed_text.hpp"
#include "mrroc/parcel.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::links {

enum class TaskCommandKind : std::uint8_t {
  start = 0,
  pause = 1,
  resume = 2,
  trigger = 3,
  stop = 4,
  end_motion = 5,
  message = 6,
  speed = 7
};

/// From the superior to its subordinate: operator to MP, MP to ECP.
struct TaskCommand {
  TaskCommandKind kind = TaskCommandKind::start;
  Message parcel;    ///< the behaviour to start, or the message; a start without one: the program itself
  double speed = 1;  ///< of `speed`: the fraction of the programmed speed, above 0, at most 1
};

enum class TaskState : std::uint8_t { idle = 0, running = 1, paused = 2, succeeded = 3, failed = 4, stopped = 5 };

/// The subordinate's answer; it also sends one whenever its state changes.
struct TaskStatus {
  TaskState state = TaskState::idle;
  ErrorReport error;  ///< the reason of a failure
  /// Where and when the error arose; `device`: robot or sensor, may be empty.
  FixedText<63> process, device;
  std::uint64_t step = 0;
  Tick error_tick = 0;
  Tick tick = 0;   ///< at which this is sent
  Message parcel;  ///< a message of the program under way; without one, this is a change of its state
};

}  // namespace mrroc::links
