#pragma once

#include <functional>
#include <string>

#include "cli/hosts/remote_hosts.hpp"
#include "cli/processes/process_group.hpp"
#include "clock/host.hpp"

namespace mrroc::cli {

inline constexpr double kStopTimeout = 5;  ///< s for robots to stop
inline constexpr double kEndTimeout = 5;   ///< s for processes to end, once the robots have stopped

/// Callbacks and options for the end of a group.
struct ShutdownListener {
  std::function<void()> turn;                             ///< waits some milliseconds, forwards the output of processes
  std::function<void(const std::string& line)> message;   ///< a process had to be killed
  std::function<void(const std::string& reason)> failed;  ///< a robot may not have stopped as it should
  double stop_timeout = kStopTimeout;                     ///< s; under a simulated clock of both times
  double end_timeout = kEndTimeout;                       ///< s
  std::function<bool()> hurried = [] { return false; };   ///< true: wait for nothing once the robots have stopped
};

/// Ends every process of a group, robots first: tasks and sensors receive SIGTERM, EDPs stop their robots, switch the
/// drives off and leave, the simulated world ends last; then the clock ends, and remaining processes are killed. A
/// failure of an EDP, the world or the clock meanwhile is reported, and the others do not wait for it. `started`:
/// whether the clock was started; before that nothing moves. Returns when all have ended, or 3 s after they have been
/// killed: a debugger, or a driver in the kernel, can keep a killed process. Main thread.
void shut_down(ProcessGroup& group, clock::ClockHost& clock, bool started, const ShutdownListener& listener);

/// Waits until all other hosts, which were instructed to stop, have ended their processes in the same order and sent
/// their records; kills the commands of agents that do not end within 15 s. Main thread.
void shut_down(RemoteHosts& hosts, const ShutdownListener& listener);

}  // namespace mrroc::cli
