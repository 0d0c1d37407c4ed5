#pragma once

#include "core/lockfree/latest_value.hpp"
#include "core/lockfree/spsc_queue.hpp"
#include "edp/command/macrostep.hpp"
#include "edp/servo/snapshot.hpp"

namespace mrroc::edp {

/// An order of the comms side to the drives.
enum class DriveOrder : std::uint8_t {
  none,
  enable,
  disable,
  recover  ///< clear what the drives have latched, then enable
};

/// The outcome of one ticket; exactly one per accepted command, unless it is `refused` and handed over again.
struct Report {
  enum class Kind : std::uint8_t {
    reply,    ///< tick v has come: the reply may leave
    refused,  ///< the servo had left the plan that the macrostep continues
    aborted   ///< the robot was stopped before tick v
  };
  Kind kind = Kind::reply;
  std::uint64_t ticket = 0;
  Tick start = 0;     ///< of the macrostep; 0 unless `reply`
  Snapshot snapshot;  ///< of the tick in which it happened
};

/// The data that the comms thread and the servo thread share. Lock-free: neither side ever waits for the other.
struct ServoChannel {
  core::SpscQueue<Macrostep, 4> macrosteps;         ///< comms -> servo: two commands, each with a stop before it
  core::SpscQueue<Report, 8> reports;               ///< servo -> comms: at most two tickets are out at a time
  core::LatestValue<Snapshot> snapshot;             ///< servo -> comms, every tick, before the reports of that tick
  core::SpscQueue<ControllerIo, 4> outputs;         ///< comms -> servo: for the next tick
  std::atomic<DriveOrder> order{DriveOrder::none};  ///< comms -> servo; the last one counts
};

}  // namespace mrroc::edp
