#include "cli/run/shutdown.hpp"

#include <signal.h>

#include <algorithm>

#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

constexpr std::int64_t kPatienceToStop = 5 * clock::kSecond;  // within which robots must stop
constexpr std::int64_t kPatienceWithKilled = 3 * clock::kSecond;
constexpr std::int64_t kPatienceWithHosts = 10 * clock::kSecond;  // longer than the timeout of their agents

void report_failures(ProcessGroup& group, clock::ClockHost& clock, const ShutdownListener& listener) {
  for (const clock::Part part : {clock::Part::drives, clock::Part::world}) {
    for (Child* const child : group.failed(part)) {
      clock.participant_died(child->name());
      const std::string& output = child->last_line();
      listener.failed("process " + child->name() + " failed at the end: " + child->how_it_ended() +
                      (child->exit_code() && !output.empty() ? ": " + output : ""));
    }
  }
}

void stop_robots(ProcessGroup& group, clock::ClockHost& clock, const ShutdownListener& listener) {
  group.signal(SIGTERM, clock::Part::task);
  clock.stop();
  const std::int64_t deadline = clock::monotonic_ns() + kPatienceToStop;
  const auto all_stand = [&group, &clock] {
    return group.all_left(clock::Part::drives, clock) && group.all_left(clock::Part::world, clock);
  };
  while (!all_stand() && clock.state() == clock::State::running && clock::monotonic_ns() < deadline) {
    report_failures(group, clock, listener);
    listener.turn();
  }
  report_failures(group, clock, listener);
  if (clock.state() == clock::State::failed) listener.failed("clock lost: " + clock.error());
  if (!all_stand() && clock.state() == clock::State::running)
    listener.failed("not every robot has stopped within " + std::to_string(kPatienceToStop / clock::kSecond) +
                    " s; clock " + clock.describe());
}

}  // namespace

void shut_down(ProcessGroup& group, clock::ClockHost& clock, bool started, const ShutdownListener& listener) {
  if (started) stop_robots(group, clock, listener);
  for (const std::string& name : group.kill_stopped())
    listener.message("process " + name + " does not continue, killing it");
  // first the signal: a process that is still being set up must receive the request before its clock refuses it
  group.signal(SIGTERM);
  clock.end();
  const std::int64_t deadline =
      clock::monotonic_ns() + static_cast<std::int64_t>(listener.end_timeout * clock::kSecond);
  while (!group.all_ended() && clock::monotonic_ns() < deadline && !listener.hurried()) listener.turn();
  for (const std::string& name : group.kill_rest()) listener.message("process " + name + " does not end, killing it");
  const std::int64_t last = clock::monotonic_ns() + kPatienceWithKilled;
  while (!group.all_ended() && clock::monotonic_ns() < last) listener.turn();
  for (const std::string& name : group.kill_rest())
    listener.message("process " + name + " is killed, but a debugger or the kernel holds it: not waiting for it");
  // a process that has left the clock may still fail or be killed: then its records are incomplete
  if (started && clock.state() == clock::State::ended) report_failures(group, clock, listener);
}

void shut_down(RemoteHosts& hosts, const ShutdownListener& listener) {
  const std::int64_t begin = clock::monotonic_ns();
  // no timeout: the time to send the steps is not known
  const auto patient = [&] { return clock::monotonic_ns() < std::max(begin, hosts.step_at()) + kPatienceWithHosts; };
  while (!hosts.all_ended() && patient() && !listener.hurried()) listener.turn();
  for (const std::string& name : hosts.kill_rest())
    listener.message("host " + name + ": its agent does not end, killing the command that started it");
  while (!hosts.all_ended()) listener.turn();
  listener.turn();  // forwards their last output
}

}  // namespace mrroc::cli
