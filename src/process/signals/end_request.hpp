#pragma once

#include "clock/clock.hpp"

namespace mrroc::process {

/// From now on SIGTERM and SIGINT request this process to end: the runner sends them, and the kernel when the runner
/// has died. Until set_up_ends() the process ends at once; from then on a request interrupts the clock. The runner
/// kills a process that does not end. Without a runner the process kills itself 5 s after the request: a task that
/// never waits must not outlive its run. SIGPIPE and SIGXFSZ are ignored. Main thread, before all others.
void receive_end_requests() noexcept;

/// A request no longer ends the process: it has to stop its robot, or to write its records. Main thread.
void set_up_ends() noexcept;

/// Whether a request has come. Any thread.
bool asked_to_end() noexcept;

/// The clock that a request interrupts, until the next call; null: none. Main thread.
void interrupt_at_request(clock::Clock* clock) noexcept;

}  // namespace mrroc::process
