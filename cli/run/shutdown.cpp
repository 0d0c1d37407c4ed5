#include "cli/run/shutdown.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>

#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

constexpr double kKillTimeout = 3;    // s
constexpr double kAgentTimeout = 15;  // s
static_assert(kAgentTimeout > kStopTimeout + kEndTimeout + kKillTimeout, "an agent may take so long");

std::int64_t ns(double seconds) { return static_cast<std::int64_t>(seconds * clock::kSecond); }

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

/// The time that robots have to stop: `timeout` s of wall time, and under a simulated clock as much simulated time as
/// long as it advances: on a busy machine it is slow.
class TimeToStop {
 public:
  TimeToStop(const clock::ClockHost& clock, double timeout) : clock_(clock), timeout_(ns(timeout)) {}

  bool is_over() {
    const std::int64_t now = clock::monotonic_ns();
    if (const std::uint64_t delta = clock_.delta(); delta != delta_) {
      delta_ = delta;
      advanced_ = now;
    }
    const bool time_is_left = static_cast<std::int64_t>(clock_.tick() - begin_) * clock_.period_ns() < timeout_;
    return now >= (time_is_left ? advanced_ : started_) + timeout_;
  }

 private:
  const clock::ClockHost& clock_;
  const std::int64_t timeout_;
  const std::int64_t started_ = clock::monotonic_ns();
  std::int64_t advanced_ = started_;
  const Tick begin_ = clock_.tick();
  std::uint64_t delta_ = clock_.delta();  // real: does not change
};

void stop_robots(ProcessGroup& group, clock::ClockHost& clock, const ShutdownListener& listener) {
  clock.stop();  // first: every task is interrupted in the same tick
  group.signal(SIGTERM, clock::Part::task);
  TimeToStop time(clock, listener.stop_timeout);
  const auto all_stand = [&group, &clock] { return group.all_left(clock::Part::drives, clock); };
  // a world without driven robots ends on its own
  while (!(all_stand() && group.all_left(clock::Part::world, clock)) && clock.state() == clock::State::running &&
         !time.is_over()) {
    report_failures(group, clock, listener);
    listener.turn();
  }
  report_failures(group, clock, listener);
  if (clock.state() == clock::State::failed) listener.failed("clock lost: " + clock.error());
  if (!all_stand() && clock.state() == clock::State::running)
    listener.failed(
        fmt::format("not every robot has stopped within {:g} s; clock {}", listener.stop_timeout, clock.describe()));
}

}  // namespace

void shut_down(ProcessGroup& group, clock::ClockHost& clock, bool started, const ShutdownListener& listener) {
  if (started) stop_robots(group, clock, listener);
  for (const std::string& name : group.kill_stopped())
    listener.message("process " + name + " does not continue, killing it");
  // first the signal: a process that is still being set up must receive the request before its clock refuses it
  group.signal(SIGTERM);
  clock.end();
  const std::int64_t deadline = clock::monotonic_ns() + ns(listener.end_timeout);
  while (!group.all_ended() && clock::monotonic_ns() < deadline && !listener.hurried()) listener.turn();
  for (const std::string& name : group.kill_rest()) listener.message("process " + name + " does not end, killing it");
  const std::int64_t last = clock::monotonic_ns() + ns(kKillTimeout);
  while (!group.all_ended() && clock::monotonic_ns() < last) listener.turn();
  for (const std::string& name : group.kill_rest())
    listener.message("process " + name + " is killed, but a debugger or the kernel holds it: not waiting for it");
  // a process that has left the clock may still fail or be killed: then its records are incomplete
  if (started && clock.state() == clock::State::ended) report_failures(group, clock, listener);
}

void shut_down(RemoteHosts& hosts, const ShutdownListener& listener) {
  const std::int64_t begin = clock::monotonic_ns();
  // no timeout: the time to send the steps is not known
  const auto patient = [&] { return clock::monotonic_ns() < std::max(begin, hosts.step_at()) + ns(kAgentTimeout); };
  while (!hosts.all_ended() && patient() && !listener.hurried()) listener.turn();
  for (const std::string& name : hosts.kill_rest())
    listener.message("host " + name + ": its agent does not end, killing the command that started it");
  while (!hosts.all_ended()) listener.turn();
  listener.turn();  // forwards their last output
}

}  // namespace mrroc::cli
