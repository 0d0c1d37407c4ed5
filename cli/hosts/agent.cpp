#include "cli/hosts/agent.hpp"

#include <poll.h>
#include <signal.h>
#include <spdlog/fmt/fmt.h>
#include <sys/epoll.h>
#include <syslog.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

#include "cli/output/outputs.hpp"
#include "cli/processes/addresses.hpp"
#include "cli/processes/resource_limits.hpp"
#include "cli/run/clock_options.hpp"
#include "cli/run/shutdown.hpp"
#include "clock/wall/monotonic.hpp"
#include "config/network/local_host.hpp"
#include "config/resources.hpp"
#include "config/table.hpp"
#include "process/arguments.hpp"
#include "process/process.hpp"

namespace mrroc::cli {

namespace {

constexpr int kTurn = 20;                                             // ms
constexpr std::int64_t kPatienceWithRunner = 5 * clock::kSecond / 2;  // to take more of the waiting lines
constexpr double kPatienceWithStart = 10;      // s beyond the deployment's `start_timeout`, which the runner applies
constexpr std::size_t kMostWaiting = 4 << 20;  // bytes that the runner has not taken
constexpr std::size_t kMostSteps = 1 << 20;    // the same, before a further step is sent

void add_to(int wake, int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  epoll_ctl(wake, EPOLL_CTL_ADD, fd, &event);
}

/// Throws an error that names the first file that differs from the runner's.
void compare_files(const AgentOrder& order, const config::Deployment& deployment) {
  const auto here = files_of(deployment);
  for (std::size_t i = 0; i < order.files.size(); ++i) {
    if (i < here.size() && here[i] == order.files[i]) continue;
    throw config::ConfigurationError(deployment.file, 0, order.files[i].first,
                                     "the file differs from the one on the machine of the runner",
                                     "the same on every host");
  }
}

}  // namespace

Agent::Agent(int in, int out, double patience_with_order)
    : patience_with_order_(patience_with_order),
      runner_(in, out),
      wake_(epoll_create1(EPOLL_CLOEXEC)),
      group_([this](const std::string& name, const std::string& line) {
        if (runner_.waiting() < kMostWaiting) runner_.write("line " + name + " " + line);
      }) {
  add_to(wake_, runner_.fd());
  add_to(wake_, signals_.descriptor());
}

Agent::~Agent() { close(wake_); }

process::ExitCode Agent::run() {
  runner_.write(std::string{kAgentGreeting});
  try {
    if (!take_order()) return process::ExitCode::usage;
    if (!stopping_) {
      prepare();
      start_processes();
      supervise();
    }
  } catch (const std::exception& error) {
    fail(process::exit_code(error), error.what());
  }
  end_processes();
  if (records_) records_->send_rest(runner_);
  runner_.write("ended");
  drain();
  return code_;
}

bool Agent::take_order() {
  const std::int64_t deadline = clock::monotonic_ns() + static_cast<std::int64_t>(patience_with_order_ * 1e9);
  std::vector<std::string> lines;
  while (!runner_.closed() && clock::monotonic_ns() < deadline) {
    group_.wait(kTurn, wake_);
    read_signals();
    if (stopping_) return true;
    for (const std::string& line : runner_.read()) {
      if (line == "go") {
        order_ = order_of_lines(lines);
        return true;
      }
      lines.push_back(line);
    }
  }
  if (!runner_.closed()) throw std::runtime_error(fmt::format("no order within {} s", patience_with_order_));
  return false;
}

void Agent::prepare() {
  config::hand_down_host(order_.host);
  config::hand_down_directories();
  deployment_ = config::load_deployment(order_.deployment);
  compare_files(order_, deployment_);
  for (const PlannedProcess& process : plan_processes(deployment_))
    if (process.host == order_.host) plan_.push_back(process);
  check_limits(plan_.size(), order_.record ? process::StepRing::memory_size() : 0);
  const in_addr runner = ipv4_of(order_.machines.front());
  const in_addr own = own_address_towards(runner);
  own_address_ = to_text(own);
  // on the runner's own machine the runner already holds the domain
  if (config::locate_host(order_.machines.front()) != config::HostPlace::local)
    domain_lock_ = std::make_unique<DomainLock>(order_.domain);
  clock::HostOptions options = clock_options(deployment_, names_of(plan_));
  options.mode = clock::Mode::real;
  clock_ = std::make_unique<clock::ClockHost>(options);
  operator_clock_ = clock_->operator_clock();
  if (deployment_.sim && deployment_.sim->host == order_.host)
    world_ = std::make_unique<world::MappedWorld>(world::MappedWorld::create());
  records_ = std::make_unique<TaskRecords>(order_, plan_);
  const bool simulates = deployment_.sim && deployment_.sim->host == order_.host;
  if (!order_.motion.empty() && simulates) {
    motion_.emplace(claim_live(order_.motion, "--motion", "the motion file"));
    if (motion_->is_own_regular_file() && ftruncate(motion_->fd(), 0) != 0)
      throw std::runtime_error("cannot write the motion file " + order_.motion.string());
  }
}

void Agent::start_processes() {
  for (const PlannedProcess& process : plan_) {
    process::Arguments arguments;
    arguments.deployment = deployment_.file;
    arguments.name = process.name;
    arguments.clock_fd = clock_->fd();
    arguments.world_fd = world_ ? world_->fd() : -1;
    arguments.domain = order_.domain;
    arguments.interface = own_address_;
    arguments.peers = order_.machines;
    if (deployment_.network.security) arguments.keys = deployment_.network.keys;
    if (process.name == "sim" && motion_) {
      arguments.motion = order_.motion;
      arguments.motion_fd = motion_->fd();
    }
    records_->add_to(arguments);
    group_.start(process, process::to_command_line(arguments), arguments.descriptors());
  }
  // after the children: they must not inherit the thread's memory priority or its socket
  link_ = std::make_unique<HostLink>(own_address_towards(ipv4_of(order_.machines.front())), order_.domain, order_.key,
                                     false, deployment_.link_timeout, operator_clock_->emergency_stop());
  add_to(wake_, link_->event_fd());
  link_->start(ipv4_of(order_.machines.front()), order_.beat_port);
  runner_.write("beat " + std::to_string(link_->port()));
}

void Agent::supervise() {
  const double patience = deployment_.start_timeout + kPatienceWithStart;
  const std::int64_t deadline = clock::monotonic_ns() + static_cast<std::int64_t>(patience * 1e9);
  while (!stopping_) {
    turn(kTurn);
    // until the start the runner's silence does not count, so this detects a runner that has vanished
    if (!started_ && clock::monotonic_ns() > deadline)
      fail(process::ExitCode::system, fmt::format("not started in time: the runner sent no start for {} s", patience));
  }
}

void Agent::turn(int milliseconds) {
  group_.wait(milliseconds, wake_);
  for (const std::string& line : runner_.read()) obey(line);
  // causes first: other events here may be their consequences
  if (!stopping_ && clock_->was_stopped()) fail(process::ExitCode::system, "its agent was stopped by a signal");
  if (!stopping_ && runner_.closed()) fail(process::ExitCode::system, "the runner is gone");
  if (!stopping_ && link_->lost()) {
    fail(process::ExitCode::system,
         fmt::format("link to the runner lost: nothing received for {} s", deployment_.link_timeout));
  }
  read_signals();
  check_children();
  if (!stopping_ && clock_->state() == clock::State::failed)
    fail(process::ExitCode::system, "clock lost: " + clock_->error());
  if (!started_) report_missing();
  send_steps();
  runner_.flush();
}

void Agent::obey(const std::string& line) {
  const auto [word, text] = split_word(line);
  if (word == "stop") {
    stopping_ = true;
  } else if (word == "start") {
    const auto epoch = whole_number(text);
    if (!epoch || *epoch <= 0) throw std::runtime_error("order '" + line + "': expected a time");
    clock_->start(*epoch);
    started_ = true;
    link_->watch();
    runner_.write("started");
  } else {
    throw std::runtime_error("order '" + line + "' is unknown: the runner has another version");
  }
}

void Agent::read_signals() {
  while (const int number = signals_.take()) {
    if (number != SIGCHLD && !stopping_)
      fail(process::ExitCode::system, "its agent was ended by signal " + std::to_string(number));
  }
}

void Agent::report_missing() {
  std::string missing;
  for (const std::string& name : clock_->wait_ready(0)) missing += " " + name;
  if (missing == missing_) return;
  missing_ = missing;
  runner_.write("missing" + missing);
}

void Agent::check_children() {
  if (stopping_) return;
  Child* const child = group_.first_lost();
  if (child == nullptr) return;
  stopping_ = true;
  code_ = process::ExitCode::system;
  runner_.write("lost " + child->name() + " " + std::to_string(child->exit_code().value_or(-1)) + " " +
                child->how_it_was_lost());
}

void Agent::fail(process::ExitCode code, const std::string& reason) {
  if (code_ != process::ExitCode::success) return;  // it is a consequence of the first failure
  stopping_ = true;
  code_ = code;
  runner_.write("failed " + std::to_string(static_cast<int>(code)) + " " + reason);
  // the runner may never read it: the cause must also be in the log of this machine
  syslog(LOG_ERR, "mrroc agent, host %s: %s", order_.host.c_str(), reason.c_str());
}

void Agent::end_processes() {
  if (!clock_) return;
  shut_down(group_, *clock_, started_,
            {.turn = [this] { turn_at_the_end(); },
             .message = [this](const std::string& line) { runner_.write("line " + line); },
             .failed = [this](const std::string& reason) { fail(process::ExitCode::system, reason); }});
  group_.wait(0, signals_.descriptor());
}

void Agent::turn_at_the_end() {
  group_.wait(kTurn, signals_.descriptor());  // not the channel: a closed one would wake it without end
  read_signals();
  runner_.read();
  send_steps();
  runner_.flush();
}

/// A runner that does not take them gets no further ones, so that there is room for what else it must receive: they are
/// dropped and counted.
void Agent::send_steps() {
  if (records_) records_->send_steps(runner_, kMostSteps);
}

void Agent::drain() {
  std::size_t waiting = runner_.waiting();
  for (std::int64_t progress = clock::monotonic_ns();
       waiting > 0 && !runner_.closed() && clock::monotonic_ns() < progress + kPatienceWithRunner;) {
    poll(nullptr, 0, 1);
    runner_.read();
    runner_.flush();
    if (runner_.waiting() < waiting) progress = clock::monotonic_ns();
    waiting = runner_.waiting();
  }
}

}  // namespace mrroc::cli
