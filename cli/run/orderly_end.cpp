#include "cli/run/orderly_end.hpp"

#include <signal.h>

#include <algorithm>

#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

constexpr std::int64_t kPatienceToStop = 5 * clock::kSecond;  // within which robots must stop
constexpr std::int64_t kPatienceWithKilled = 3 * clock::kSecond;
constexpr std::int64_t kPatienceWithHosts = 10 * clock::kSecond;  // longer than the timeout of their agents

void look_for_failures(Crew& crew, clock::ClockHost& clock, const EndListener& listener) {
  for (const clock::Part part : {clock::Part::drives, clock::Part::world}) {
    for (Child* const child : crew.failed(part)) {
      clock.participant_died(child->name());
      const std::string& said = child->last_line();
      listener.failed("process " + child->name() + " failed at the end: " + child->how_it_ended() +
                      (child->exit_code() && !said.empty() ? ": " + said : ""));
    }
  }
}

void stop_robots(Crew& crew, clock::ClockHost& clock, const EndListener& listener) {
  crew.signal(SIGTERM, clock::Part::task);
  clock.stop();
  const std::int64_t deadline = clock::monotonic_ns() + kPatienceToStop;
  const auto all_stand = [&crew, &clock] {
    return crew.all_left(clock::Part::drives, clock) && crew.all_left(clock::Part::world, clock);
  };
  while (!all_stand() && clock.state() == clock::State::running && clock::monotonic_ns() < deadline) {
    look_for_failures(crew, clock, listener);
    listener.turn();
  }
  look_for_failures(crew, clock, listener);
  if (clock.state() == clock::State::failed) listener.failed("clock lost: " + clock.error());
  if (!all_stand() && clock.state() == clock::State::running)
    listener.failed("not every robot has stopped within " + std::to_string(kPatienceToStop / clock::kSecond) +
                    " s; clock " + clock.describe());
}

}  // namespace

void end_in_order(Crew& crew, clock::ClockHost& clock, bool started, const EndListener& listener) {
  if (started) stop_robots(crew, clock, listener);
  for (const std::string& name : crew.kill_stopped())
    listener.message("process " + name + " does not continue, killing it");
  // first the signal: a process that is still being set up must receive the request before its clock refuses it
  crew.signal(SIGTERM);
  clock.end();
  const std::int64_t deadline =
      clock::monotonic_ns() + static_cast<std::int64_t>(listener.end_timeout * clock::kSecond);
  while (!crew.all_ended() && clock::monotonic_ns() < deadline && !listener.hurried()) listener.turn();
  for (const std::string& name : crew.kill_rest()) listener.message("process " + name + " does not end, killing it");
  const std::int64_t last = clock::monotonic_ns() + kPatienceWithKilled;
  while (!crew.all_ended() && clock::monotonic_ns() < last) listener.turn();
  for (const std::string& name : crew.kill_rest())
    listener.message("process " + name + " is killed, but a debugger or the kernel holds it: not waiting for it");
  // a process that has left the clock may still fail or be killed: then its records are incomplete
  if (started && clock.state() == clock::State::ended) look_for_failures(crew, clock, listener);
}

void end_in_order(RemoteHosts& hosts, const EndListener& listener) {
  const std::int64_t begin = clock::monotonic_ns();
  // no timeout: the time to write a trace is not known
  const auto patient = [&] { return clock::monotonic_ns() < std::max(begin, hosts.traced_at()) + kPatienceWithHosts; };
  while (!hosts.all_ended() && patient() && !listener.hurried()) listener.turn();
  for (const std::string& name : hosts.kill_rest())
    listener.message("host " + name + ": its agent does not end, killing the command that started it");
  while (!hosts.all_ended()) listener.turn();
  listener.turn();  // forwards their last output
}

}  // namespace mrroc::cli
