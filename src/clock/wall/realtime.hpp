#pragma once

#include <string>

namespace mrroc::clock {

/// Makes the calling thread SCHED_FIFO at `priority` (1..99) and locks the process's memory, present and future, as
/// pages are touched. Memory is locked only where no limit can refuse later mappings: with CAP_IPC_LOCK, or where
/// RLIMIT_MEMLOCK is unlimited or may be raised so. Threads created by it afterwards inherit the class and priority.
/// Returns an empty text when all was granted, otherwise a warning that names each refused request, the reason, and the
/// privilege to grant. To be called once, before the DDS domain is created and the servo thread is started.
std::string request_realtime(int priority);

/// What the system would refuse to a process that calls `request_realtime(priority)`: "real-time priority", "locked
/// memory", both with " and " between, or nothing. It asks and gives back what was granted; the calling thread keeps
/// its class.
std::string refused_realtime(int priority);

/// For a thread without real-time priority: the shortest time slice that Linux gives, 0.1 ms (since 6.12; before, no
/// effect), so that it comes sooner to a processor that others use, with the same share of it. It needs no privilege.
void take_short_slice() noexcept;

/// Pins the calling thread, and the threads and processes that it starts from now on, to the CPU on which it runs:
/// lockstep is serial, and a thread switch on one CPU costs a fraction of waking another. Returns that CPU, or -1 when
/// the system refuses.
int pin_to_one_cpu() noexcept;

}  // namespace mrroc::clock
