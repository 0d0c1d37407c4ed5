// The other process of the tests: links_peer ROLE DOMAIN PREFIX LEASE [CLOCK_FD | INTERFACE,HOST... | KEYS]. It runs
// until it is killed or its parent ends.

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "clock/participant.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/exchange/robot_responder.hpp"
#include "links/telemetry/status_publisher.hpp"
#include "links/test_clock.hpp"
#include "mrroc/errors.hpp"

namespace {

using namespace mrroc;
using namespace mrroc::links;

// on a machine that is busy with other tests a command may be old
constexpr double kAnyAge = 1000;

/// Answers every command at once; the reply contains the number of stale commands so far.
void respond(clock::Clock& clock, RobotResponder& link) {
  RobotCommand command;
  std::uint64_t sequence = 0;
  for (;;) {
    while (link.take(command, sequence)) {
      RobotState state;
      state.tick = command.start_tick;
      state.joints = command.joints;
      state.late_commands = static_cast<std::uint32_t>(link.counters().stale);
      link.reply(state, sequence);
    }
    if (clock.wait(kNever) == clock::Wake::interrupted) return;
  }
}

/// Answers every command three ticks later, with the tick of the answer.
void respond_in_lockstep(clock::Clock& clock, RobotResponder& link) {
  Tick due = kNever;
  RobotCommand command;
  std::uint64_t sequence = 0;
  while (clock.wait(due) != clock::Wake::interrupted) {
    if (link.take(command, sequence)) due = clock.tick() + 3;
    if (clock.tick() < due) continue;
    RobotState state;
    state.tick = clock.tick();
    state.joints = command.joints;
    link.reply(state, sequence);
    due = kNever;
  }
}

/// Acts like a commander, whether it is accepted or not; `mark` is the start tick of its commands.
void command(Domain& domain, clock::Clock& clock, const std::string& prefix, Tick mark) {
  RobotRequester link(domain, clock, prefix, "responder");
  RobotCommand command;
  command.start_tick = mark;
  for (;;) {
    try {
      link.connect(0.02);
    } catch (const SystemError&) {
      // it tries to connect, and continues in any case
    }
    link.send(command);
  }
}

void publish(Domain& domain, const std::string& prefix) {
  StatusPublisher publisher(domain, prefix);
  ProcessStatus status;
  status.process.assign("process" + std::to_string(::getpid()));
  status.pid = ::getpid();
  publisher.publish(status);
  ::pause();
}

}  // namespace

int main(int argc, char** argv) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::string& role = arguments.at(0);
  DomainOptions options;
  options.id = std::stoi(arguments.at(1));
  options.lease = std::stod(arguments.at(3));
  const std::string& prefix = arguments.at(2);
  if (role == "remote") {
    std::istringstream words(arguments.at(4));
    std::getline(words, options.interface, ',');
    for (std::string host; std::getline(words, host, ',');) options.hosts.push_back(host);
  }
  const bool commands = role == "commander" || role == "foreigner";
  if (role == "respond" || role == "status" || commands) options.keys = arguments.at(4);
  try {
    if (role == "lockstep") {
      const auto clock = clock::attach_clock(std::stoi(arguments.at(4)), "edp");
      Domain domain(options);
      RobotResponder link(domain, *clock, prefix, kAnyAge);
      if (clock->start()) respond_in_lockstep(*clock, link);
      return 0;
    }
    Domain domain(options);
    TestClock clock;
    if (role == "status") {
      publish(domain, prefix);
    } else if (commands) {
      command(domain, clock, prefix, role == "commander" ? 1 : 666);
    } else {
      RobotResponder link(domain, clock, prefix, role == "cautious" ? RobotResponder::kMaxAge : kAnyAge);
      respond(clock, link);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "links_peer %s: %s\n", role.c_str(), error.what());
    return 1;
  }
}
