// Cost of one step of Move between an ECP and an EDP, against a bare Cyclone DDS ping-pong of the same messages.
//   link_roundtrip [--rounds n] [--steps n] [--realtime] [--domain n] [--keys folder]
//
// Two processes. The asking one runs blocks of `steps` exchanges in turn: the bare ping-pong, answered by a thread that
// a listener wakes (the yardstick); a real Move of an IRb-6, whose EDP side is all of an EDP but its grid: the servo is
// ticked as soon as a command of N = 1, v = 1 has been accepted, so that nothing waits for the time of a tick; the bare
// ping-pong answered inside the listener; and the same Move without a link, with its EDP side in the asking thread:
// what a step computes. With keys (`mrroc keys folder`) also the bare ping-pong of the first kind in a domain with DDS
// Security, the one after `n`, between the same two processes. A step lasts from one next_state() to the next. A round
// is one block of each; the figures are medians over the rounds of each round's quantiles and ratios.

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "clock/host.hpp"
#include "clock/participant.hpp"
#include "clock/wall/monotonic.hpp"
#include "clock/wall/realtime.hpp"
#include "edp_without_grid.hpp"
#include "links/exchange/bare_ping_pong.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/exchange/robot_responder.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"
#include "one_robot_task.hpp"
#include "round_times.hpp"

namespace mrroc {
namespace {

constexpr double kBar = 1.15;
constexpr double kGoal = 1.08;
constexpr double kTimeout = 10;    // s, of hand-shakes
constexpr double kLease = 20;      // s, outlasts any stall of a busy machine
constexpr Tick kPatience = 10000;  // ticks that a reply may be late; outlasts any stall too
constexpr int kPriority = 60;

const std::string kPrefix = "roundtrip/irb6";
const std::string kBarePrefix = "roundtrip/bare";
const std::string kListenerPrefix = "roundtrip/listener";
const std::string kSignedPrefix = "roundtrip/signed";

struct Options {
  int rounds = 20;
  int steps = 2000;
  int domain = 77;
  bool realtime = false;
  std::string keys;  // folder; empty: without the secured ping-pong
};

/// The second domain of a process, with DDS Security; empty without keys.
std::unique_ptr<links::Domain> secured_domain(const Options& options) {
  if (options.keys.empty()) return nullptr;
  return std::make_unique<links::Domain>(
      links::DomainOptions{.id = options.domain + 1, .lease = kLease, .keys = options.keys});
}

void prepare_process(const Options& options) {
  if (!options.realtime) return;
  const std::string warning = clock::request_realtime(kPriority);
  if (!warning.empty()) std::fprintf(stderr, "%s\n", warning.c_str());
}

// ---- EDP
// -------------------------------------------------------------------------------------------------------------

class EdpSide {
 public:
  EdpSide(links::Domain& domain, clock::Clock& clock)
      : clock_(clock), edp_(clock.period()), responder_(domain, clock, kPrefix) {}

  void serve() {
    if (!clock_.start()) return;
    while (clock_.wait(kNever) != clock::Wake::interrupted) {
      for (std::uint64_t number = 0; responder_.take(command_, number);)
        edp_.execute(command_, number,
                     [this](const RobotState& state, std::uint64_t answered) { responder_.reply(state, answered); });
    }
  }

 private:
  clock::Clock& clock_;
  Edp edp_;
  links::RobotResponder responder_;
  RobotCommand command_;
};

int run_edp(int clock_fd, const Options& options) {
  prepare_process(options);
  links::Domain domain({.id = options.domain, .lease = kLease});
  const auto secured = secured_domain(options);
  const auto clock = clock::attach_clock(clock_fd, "edp");
  const links::BareEcho thread(domain, kBarePrefix, links::BareEcho::Where::thread);
  const links::BareEcho listener(domain, kListenerPrefix, links::BareEcho::Where::listener);
  std::unique_ptr<links::BareEcho> with_keys;
  if (secured) with_keys = std::make_unique<links::BareEcho>(*secured, kSignedPrefix, links::BareEcho::Where::thread);
  std::make_unique<EdpSide>(domain, *clock)->serve();
  return 0;
}

// ---- ECP
// -------------------------------------------------------------------------------------------------------------

class EcpSide {
 public:
  EcpSide(links::Domain& domain, links::Domain* secured, clock::Clock& clock, int steps)
      : steps_(steps),
        link_(domain, clock, kPrefix, "edp", kPatience),
        bare_(domain, kBarePrefix),
        listener_(domain, kListenerPrefix),
        no_link_(clock.period()),
        task_(clock, link_),
        robot_(task_, "irb6", load_models()),
        local_task_(clock, no_link_),
        local_robot_(local_task_, "irb6", load_models()) {
    robot_.set_macrostep(1, 1);
    local_robot_.set_macrostep(1, 1);
    link_.connect(kTimeout);
    bare_.connect(kTimeout);
    listener_.connect(kTimeout);
    if (secured != nullptr) {
      with_keys_ = std::make_unique<links::BarePing>(*secured, kSignedPrefix);
      with_keys_->connect(kTimeout);
    }
    stamps_.reserve(static_cast<std::size_t>(steps) + 2);
  }

  /// One block of each kind; the order rotates from round to round, so that no kind always follows the same one.
  void run_round(bool forwards) {
    if (forwards) ping(bare_, bare);
    move(robot_, moves);
    if (!forwards) ping(bare_, bare);
    ping(listener_, listener);
    move(local_robot_, local);
    if (with_keys_) ping(*with_keys_, with_keys);
  }

  RoundTimes bare, moves, listener, local, with_keys;

 private:
  void ping(links::BarePing& link, RoundTimes& times) {
    stamps_.clear();
    stamps_.push_back(clock::monotonic_ns());
    for (int i = 0; i < steps_; ++i) {
      link.exchange();
      stamps_.push_back(clock::monotonic_ns());
    }
    times.add(stamps_);
  }

  void move(Robot& robot, RoundTimes& times) {
    stamps_.clear();
    if (&robot == &robot_) direction_ = -direction_;
    Cycloid cycloid(robot, steps_, direction_, stamps_);
    // one more: the end of a step is the next one's next_state()
    Move({robot}, {}, cycloid.until(ElapsedSteps{static_cast<std::uint64_t>(steps_) + 1}));
    times.add(stamps_);
  }

  const int steps_;
  links::RobotRequester link_;
  links::BarePing bare_;
  links::BarePing listener_;
  std::unique_ptr<links::BarePing> with_keys_;  // null: without keys
  NoLink no_link_;
  OneRobotTask task_;
  Robot robot_;
  OneRobotTask local_task_;
  Robot local_robot_;
  double direction_ = 1;
  std::vector<std::int64_t> stamps_;
};

void print_row(const char* name, const RoundTimes& times, const RoundTimes& yardstick) {
  std::printf("%-28s %8.1f %8.1f   %8.2f %8.2f\n", name, quantile(times.p50, 0.5), quantile(times.p99, 0.5),
              median_ratio(times.p50, yardstick.p50), median_ratio(times.p99, yardstick.p99));
}

int run_ecp(int clock_fd, const Options& options) {
  prepare_process(options);
  links::Domain domain({.id = options.domain, .lease = kLease});
  const auto secured = secured_domain(options);
  const auto clock = clock::attach_clock(clock_fd, "ecp");
  const auto ecp = std::make_unique<EcpSide>(domain, secured.get(), *clock, options.steps);
  if (!clock->start()) return 2;
  ecp->run_round(true);  // warm-up
  ecp->bare = ecp->moves = ecp->listener = ecp->local = ecp->with_keys = {};
  for (int round = 0; round < options.rounds; ++round) ecp->run_round(round % 2 == 0);

  std::printf("us, %d rounds of %d              p50      p99   p50 ratio p99 ratio\n", options.rounds, options.steps);
  print_row("bare DDS, thread answers", ecp->bare, ecp->bare);
  print_row("Move step", ecp->moves, ecp->bare);
  print_row("bare DDS, listener answers", ecp->listener, ecp->bare);
  print_row("Move step without a link", ecp->local, ecp->bare);
  if (secured) print_row("bare DDS, thread, with keys", ecp->with_keys, ecp->bare);
  const double ratio = median_ratio(ecp->moves.p50, ecp->bare.p50);
  const bool pass = ratio <= kBar;
  std::printf("Move step / bare DDS at p50: thread %.3f, listener %.3f; bar %.2f of the thread: %s; goal %.2f: %s\n",
              ratio, median_ratio(ecp->moves.p50, ecp->listener.p50), kBar, pass ? "PASS" : "FAIL", kGoal,
              ratio <= kGoal ? "PASS" : "FAIL");
  return pass ? 0 : 1;
}

// ---- the deployment
// --------------------------------------------------------------------------------------------------

using Side = int (*)(int clock_fd, const Options& options);

pid_t start(Side side, int clock_fd, const Options& options) {
  const pid_t pid = ::fork();
  if (pid != 0) return pid;
  int code = 2;
  try {
    code = side(clock_fd, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  std::fflush(nullptr);
  ::_exit(code);  // the clock's host is the parent's
}

int exit_code(pid_t pid) {
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 2;
}

int run(const Options& options) {
  clock::ClockHost host({.mode = clock::Mode::real, .participants = {"edp", "ecp"}});
  const pid_t edp = start(&run_edp, host.fd(), options);
  const pid_t ecp = start(&run_ecp, host.fd(), options);
  if (host.wait_ready(2 * kTimeout).empty()) {
    host.start();
  } else {
    host.end();
  }
  const int code = exit_code(ecp);
  host.end();
  return exit_code(edp) == 0 ? code : 2;
}

/// Exits when the arguments are invalid.
Options parse(int count, char** arguments) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string_view name = arguments[i];
    const int value = i + 1 < count ? std::atoi(arguments[i + 1]) : 0;
    if (name == "--realtime") {
      options.realtime = true;
      continue;
    }
    ++i;
    if (name == "--keys" && i < count) {
      options.keys = arguments[i];
    } else if (name == "--rounds" && value > 0) {
      options.rounds = value;
    } else if (name == "--steps" && value >= 500) {
      options.steps = value;
    } else if (name == "--domain" && value > 0) {
      options.domain = value;
    } else {
      std::fprintf(stderr,
                   "usage: link_roundtrip [--rounds n] [--steps n, at least 500] [--domain n] [--realtime] [--keys "
                   "folder]\n");
      std::exit(2);
    }
  }
  return options;
}

}  // namespace
}  // namespace mrroc

int main(int count, char** arguments) { return mrroc::run(mrroc::parse(count, arguments)); }
