#pragma once

#include <functional>
#include <string>

#include "cli/hosts/remote_hosts.hpp"
#include "cli/processes/crew.hpp"
#include "clock/host.hpp"

namespace mrroc::cli {

/// Callbacks and options for the end of a crew.
struct EndListener {
  std::function<void()> turn;                             ///< waits some milliseconds, forwards the output of processes
  std::function<void(const std::string& line)> message;   ///< a process had to be killed
  std::function<void(const std::string& reason)> failed;  ///< a robot may not have stopped as it should
  double end_timeout = 3;                                 ///< s for processes to end, once the robots have stopped
  std::function<bool()> hurried = [] { return false; };   ///< true: wait for nothing once the robots have stopped
};

/// Ends every process of a crew, robots first: tasks and sensors receive SIGTERM, EDPs stop their robots, switch the
/// drives off and leave, the simulated world ends last; then the clock ends, and remaining processes are killed. A
/// failure of an EDP, the world or the clock meanwhile is reported, and the others do not wait for it. `started`:
/// whether the clock was started; before that nothing moves. Returns when all have ended, or 3 s after they have been
/// killed: a debugger, or a driver in the kernel, can keep a killed process. Main thread.
void end_in_order(Crew& crew, clock::ClockHost& clock, bool started, const EndListener& listener);

/// Waits until all other hosts, which were instructed to stop, have ended their processes in the same order and sent
/// their records; kills the commands of agents that do not end within 10 s. Main thread.
void end_in_order(RemoteHosts& hosts, const EndListener& listener);

}  // namespace mrroc::cli
