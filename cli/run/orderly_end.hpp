#pragma once

#include <functional>
#include <string>

#include "cli/hosts/remote_hosts.hpp"
#include "cli/processes/crew.hpp"
#include "clock/host.hpp"

namespace mrroc::cli {

/// What whoever ends a crew does meanwhile, and is told.
struct EndListener {
  std::function<void()> turn;                             ///< waits some milliseconds, hands on what processes say
  std::function<void(const std::string& line)> message;   ///< a process had to be killed
  std::function<void(const std::string& reason)> failed;  ///< a robot may not have stopped as it should
  double end_timeout = 3;                                 ///< s for processes to end, once the robots stand
  std::function<bool()> hurried = [] { return false; };   ///< when the robots stand nothing more is waited for
};

/// Ends every process of a crew, robots first: tasks and sensors are asked to go (SIGTERM), EDPs stop their robots,
/// switch the drives off and leave, the simulated world goes last; then the clock ends, and who is still there is
/// killed. An EDP, world or clock that fails meanwhile is reported, and the others do not wait for it. `started`: the
/// clock was; before that nothing moves. Returns when all have ended, or 3 s after they have been killed: a debugger,
/// or a driver in the kernel, can keep a killed process. Main thread.
void end_in_order(Crew& crew, clock::ClockHost& clock, bool started, const EndListener& listener);

/// Waits until all other hosts, which have been told to stop, have ended their processes so and sent what they
/// recorded; the commands that started agents which do not end within 10 s are killed. Main thread.
void end_in_order(RemoteHosts& hosts, const EndListener& listener);

}  // namespace mrroc::cli
