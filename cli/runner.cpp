#include "cli/runner.hpp"

#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <stdexcept>

#include "cli/clock_options.hpp"
#include "cli/launch.hpp"
#include "cli/orderly_end.hpp"
#include "cli/report.hpp"
#include "clock/monotonic.hpp"
#include "clock/realtime.hpp"
#include "config/resources.hpp"
#include "mrroc/errors.hpp"
#include "process/process.hpp"

namespace mrroc::cli {

namespace {

constexpr int kTurn = 20;                                         // ms between looks at the mail
constexpr double kHandShake = 0.1;                                // s of one try to reach the MP
constexpr double kPatienceWithCause = 0.5;                        // s from a task's word of a loss to its cause
constexpr std::int64_t kPatienceWithHosts = 10 * clock::kSecond;  // longer than that of their agents

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Those of one host; "": of this machine.
std::vector<PlannedProcess> processes_on(const std::string& host, const std::vector<PlannedProcess>& plan) {
  std::vector<PlannedProcess> found;
  for (const PlannedProcess& process : plan)
    if (process.host == host) found.push_back(process);
  return found;
}

/// Between machines a process that has died and a cut link look alike to its peers.
bool tells_of_a_loss(ErrorCode code) { return code == ErrorCode::process_died || code == ErrorCode::link_lost; }

int open_signals() {
  sigset_t set;
  sigemptyset(&set);
  // SIGTTOU: a terminal may be set to stop those who write to it from the background
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGTTOU, SIGCHLD}) sigaddset(&set, number);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  signal(SIGCHLD, SIG_DFL);  // whoever has started this may ignore it, and then nobody hears of a death
  signal(SIGPIPE, SIG_IGN);  // nobody has to read what the runner says
  return signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

}  // namespace

Runner::Runner(const config::Deployment& deployment, RunOptions options)
    : deployment_(deployment),
      options_(std::move(options)),
      plan_(plan_processes(deployment_)),
      black_boxes_(options_.black_box, deployment_, plan_),
      progress_(names_of(plan_), deployment_.servo_period, options_.quiet),
      domain_lock_(deployment_.domain),
      clock_(clock_options(deployment_, names_of(processes_on("", plan_)))),
      operator_clock_(clock_.operator_clock()),
      signals_(open_signals()),
      crew_([this](const std::string& name, const std::string& line) { progress_.message(name + " | " + line); }),
      faults_(options_.faults, plan_, clock_, crew_, deployment_.clock != config::ClockMode::real,
              [this](const std::string& line) { progress_.message(line); }),
      input_(STDIN_FILENO),
      heartbeats_(deployment_.heartbeat_timeout),
      stall_(clock_) {
  if (deployment_.sim && deployment_.sim->host.empty())
    world_ = std::make_unique<sim::MappedWorld>(sim::MappedWorld::create());
}

Runner::~Runner() {
  clock_.end();
  clock_.join();  // its events use the links
  if (signals_ >= 0) close(signals_);
}

process::ExitCode Runner::run() {
  check_somebody_answers(deployment_, input_.attended());
  check_network(deployment_.network);
  // before anything is started: a run whose trace is lost would be in vain
  const TraceParts trace(options_.trace, plan_);
  if (!options_.snapshots.empty()) std::filesystem::create_directories(options_.snapshots);
  // lockstep is serial by nature: one CPU for all is several times faster than two
  if (deployment_.clock != config::ClockMode::real) clock::pin_to_one_cpu();
  guard([&] {
    start_processes(trace);
    if (!stopping_) pass_barrier();
    if (!stopping_) supervise();
  });
  end_processes();
  result_.statuses = heartbeats_.statuses();
  try {
    trace.join(plan_, deployment_.clock);
  } catch (const std::exception& error) {
    fail(process::ExitCode::system, error.what());  // a success is none without its trace
  }
  // a task that has failed has written its own; here are those that died, or were ended because of it
  if (result_.code == process::ExitCode::system)
    if (const std::string line = black_boxes_.save_rest(); !line.empty()) progress_.message(line);
  if (!options_.quiet) progress_.message(report_of(deployment_, result_));
  return result_.code;
}

void Runner::guard(const std::function<void()>& step) {
  try {
    step();
  } catch (const std::exception& error) {
    fail(process::exit_code(error), error.what());
  }
}

void Runner::start_processes(const TraceParts& trace) {
  // a program may lie elsewhere than the others: it finds them, and the data files, where the runner does
  config::hand_down_directories();
  std::vector<PlannedProcess> order = plan_;
  std::mt19937_64 random(options_.shuffle_seed.value_or(0));
  if (options_.shuffle_seed) std::shuffle(order.begin(), order.end(), random);
  hosts_ = std::make_unique<RemoteHosts>(deployment_, host_listener(trace), operator_clock_->emergency_stop());
  hosts_->start_agents(common_order());
  const Surroundings surroundings{.deployment = deployment_,
                                  .options = options_,
                                  .trace = trace,
                                  .black_boxes = black_boxes_,
                                  .domain = domain_lock_.domain(),
                                  .own_address = hosts_->own_address(),
                                  .peers = hosts_->machines(),
                                  .clock_fd = clock_.fd(),
                                  .world_fd = world_ ? world_->fd() : -1};
  for (const PlannedProcess& process : order) {
    if (!process.host.empty()) continue;
    if (options_.shuffle_seed && !turn(static_cast<int>(random() % 300))) return;
    const process::Arguments arguments = arguments_for(process, surroundings);
    crew_.start(process, process::to_command_line(arguments), arguments.descriptors());
  }
  open_links(domain_options(surroundings));  // after the children: they would inherit the domain's sockets
}

void Runner::open_links(const links::DomainOptions& options) {
  domain_ = std::make_unique<links::Domain>(options);
  collector_ = std::make_unique<links::StatusCollector>(*domain_, deployment_.name);
  mp_ = std::make_unique<links::TaskSuperior>(*domain_, *operator_clock_, deployment_.name + "/mp", "mp");
  commands_ = std::make_unique<TaskCommands>(*mp_);
  desk_ = std::make_unique<OperatorDesk>(deployment_, *domain_, *operator_clock_, input_,
                                         [this](const std::string& line) { progress_.message(line); });
}

void Runner::pass_barrier() {
  const double deadline = operator_clock_->wall_seconds() + deployment_.start_timeout;
  std::vector<std::string> missing;
  while (!(missing = not_ready()).empty()) {
    if (!turn(kTurn)) return;
    if (operator_clock_->wall_seconds() > deadline) {
      fail(process::ExitCode::system,
           "not ready within " + std::to_string(deployment_.start_timeout) + " s: " + joined(missing));
      return;
    }
  }
  if (!connect_to_mp(deadline)) return;
  commands_->schedule(clock_, deployment_, *desk_);
  faults_.schedule();
  const double now = operator_clock_->wall_seconds();
  heartbeats_.expect(names_of(plan_), now);
  result_.wall_seconds = now;
  task_started_ = true;
  clock_.start(hosts_->start());
}

HostListener Runner::host_listener(const TraceParts& trace) {
  for (const PlannedProcess& process : plan_) {
    const std::filesystem::path part = trace.of(process);
    if (!process.host.empty() && !part.empty()) remote_traces_[process.name].open(part);
  }
  HostListener listener;
  listener.message = [this](const std::string& line) { progress_.message(line); };
  listener.lost = [this](const std::string& name, int exit_code, const std::string& how) {
    process_lost(name, exit_code, how);
  };
  listener.failed = [this](process::ExitCode code, const std::string& reason) { fail(code, reason); };
  listener.trace = [this](const std::string& name, const std::string& line) { remote_traces_[name] << line << '\n'; };
  listener.last_step = [this](const std::string& name, const std::string& line) { black_boxes_.take(name, line); };
  return listener;
}

AgentOrder Runner::common_order() const {
  AgentOrder order;
  order.domain = domain_lock_.domain();
  order.trace = !options_.trace.empty();
  order.black_box = !options_.black_box.empty();
  if (!options_.motion.empty()) order.motion = std::filesystem::absolute(options_.motion);
  return order;
}

std::vector<std::string> Runner::not_ready() {
  std::vector<std::string> missing = clock_.wait_ready(0);
  const std::vector<std::string> elsewhere = hosts_->missing();
  missing.insert(missing.end(), elsewhere.begin(), elsewhere.end());
  return missing;
}

bool Runner::connect_to_mp(double deadline) {
  for (;;) {
    try {
      mp_->connect(kHandShake);
      return true;
    } catch (const SystemError& error) {
      if (error.code() != ErrorCode::link_lost || operator_clock_->wall_seconds() > deadline) throw;
    }
    if (!turn(0)) return false;
  }
}

void Runner::supervise() {
  while (turn(kTurn)) {
    check_heartbeats();
    if (const std::string line = stall_.look(operator_clock_->wall_seconds()); !line.empty()) progress_.message(line);
  }
}

bool Runner::turn(int milliseconds) {
  crew_.wait(milliseconds, hosts_ ? hosts_->descriptor(signals_) : signals_);
  read_signals();
  if (collector_ != nullptr) read_statuses();
  faults_.tell();
  // first the causes: what the task says about a death or a lost clock is but their consequence
  check_stop();
  check_children();
  if (hosts_) hosts_->look();
  check_clock();
  if (task_started_ && !stopping_) look_at_desk();  // what was said before the end is shown before it
  if (task_started_) read_task_status();
  progress_.draw();
  return !stopping_;
}

void Runner::read_signals() {
  signalfd_siginfo info;
  while (read(signals_, &info, sizeof info) == static_cast<ssize_t>(sizeof info)) {
    if (info.ssi_signo == SIGTSTP)
      progress_.message("Ctrl-Z does nothing: robots that move must be watched");
    else if (info.ssi_signo != SIGCHLD)
      interrupt_by_operator();
  }
}

void Runner::interrupt_by_operator() {
  if (stopping_) return;
  ++interrupts_;
  if (interrupts_ > 1 || !task_started_) {
    fail(process::ExitCode::stopped, "ended by the operator");
    return;
  }
  progress_.message("stopping (once more to end at once)");
  commands_->send(links::TaskCommandKind::stop);
}

void Runner::read_statuses() {
  collector_->poll();
  for (const auto& [name, process] : collector_->processes())
    if (heartbeats_.take(process.status, operator_clock_->wall_seconds())) progress_.update(process.status);
}

void Runner::await_cause() {
  // of an agent that stands still its processes leave before its silence has lasted long enough
  const double silence = deployment_.hosts_used().empty() ? 0 : deployment_.link_timeout;
  const double deadline = operator_clock_->wall_seconds() + kPatienceWithCause + silence;
  while (!stopping_ && operator_clock_->wall_seconds() < deadline) {
    crew_.wait(kTurn, hosts_ ? hosts_->descriptor(signals_) : signals_);
    read_signals();
    check_children();
    if (hosts_) hosts_->look();
    if (task_started_ && !stopping_) look_at_desk();  // an emergency stop may not wait for it
  }
}

void Runner::read_task_status() {
  links::TaskStatus status;
  std::uint64_t last_command = 0;
  while (mp_->take(status, last_command)) {
    check_children();  // a death may be why the task ends
    if (faults_.ends_run()) continue;
    if (!stopping_ && status.state == links::TaskState::failed && tells_of_a_loss(status.error.code)) await_cause();
    // asked by somebody else, with a signal to the MP alone: its end is that of a process
    if (!stopping_ && status.state == links::TaskState::stopped && !commands_->stop_sent()) await_cause();
    if (status.state == links::TaskState::running || status.state == links::TaskState::paused || stopping_) continue;
    result_.ticks = status.tick;
    if (status.state == links::TaskState::failed) {
      fail(process::exit_code(status.error.error_class),
           std::string{describe(status.error.error_class)} + ": " + std::string{describe(status.error.code)} + ": " +
               std::string{status.error.detail.view()} + black_boxes_.told());
    } else if (status.state == links::TaskState::stopped) {
      fail(process::ExitCode::stopped, "stopped by the operator");
    } else {
      stopping_ = true;
    }
  }
}

void Runner::look_at_desk() {
  desk_->look();
  progress_.pause(desk_->waits_for_line());
}

void Runner::check_stop() {
  if (!stopping_ && clock_.was_stopped())
    fail(process::ExitCode::system,
         "mrroc run itself was stopped by a signal: its robots have braked, its processes left");
}

void Runner::check_children() {
  if (stopping_) return;
  if (crew_.first_lost() == nullptr) return;
  // a second look: the cause came before what it caused, but may have been looked at too early
  Child* const child = crew_.first_lost(faults_.struck());
  std::string how = (child->ended() ? "died: " : "is ") + child->how_it_ended();
  if (child->exit_code() && !child->last_line().empty()) how += ": " + child->last_line();
  if (task_started_) how += " [tick " + std::to_string(std::min(clock_.stop_tick(), clock_.tick())) + "]";
  faults_.tell_noticed(child->name());
  clock_.participant_died(child->name());
  process_lost(child->name(), child->exit_code().value_or(-1), how);
}

void Runner::process_lost(const std::string& name, int exit_code, const std::string& how) {
  const auto named = [&name](const PlannedProcess& process) { return process.name == name; };
  const auto process = std::find_if(plan_.begin(), plan_.end(), named);
  const bool here = process == plan_.end() || process->host.empty();
  fail(code_of_death(exit_code), "process " + name + (here ? " " : " on host " + process->host + " ") + how);
}

process::ExitCode Runner::code_of_death(int exit_code) const {
  // a process that refuses its part of the deployment says how grave that is; later it would be missed by the others
  const bool refused = !task_started_ && exit_code >= static_cast<int>(process::ExitCode::task_failed) &&
                       exit_code <= static_cast<int>(process::ExitCode::hardware);
  return refused ? static_cast<process::ExitCode>(exit_code) : process::ExitCode::system;
}

void Runner::check_heartbeats() {
  if (stopping_) return;
  if (const std::string name = heartbeats_.silent(operator_clock_->wall_seconds()); !name.empty())
    fail(process::ExitCode::system,
         "process " + name + " is silent for " + std::to_string(deployment_.heartbeat_timeout) + " s");
}

void Runner::check_clock() {
  if (!stopping_ && clock_.state() == clock::State::failed)
    fail(process::ExitCode::system, "clock lost: " + clock_.error());
}

void Runner::fail(process::ExitCode code, std::string reason) {
  if (result_.code != process::ExitCode::success) return;  // it is but a consequence
  faults_.tell();
  stopping_ = true;
  result_.code = code;
  result_.reason = std::move(reason);
  progress_.error("mrroc: " + deployment_.name + ": " + result_.reason);
}

void Runner::turn_at_the_end() {
  guard([this] { turn(kTurn); });
}

void Runner::end_hosts() {
  const std::int64_t begin = clock::monotonic_ns();
  // a trace takes as long as it takes
  const auto patient = [&] {
    return clock::monotonic_ns() < std::max(begin, hosts_->traced_at()) + kPatienceWithHosts;
  };
  while (!hosts_->all_ended() && patient()) turn_at_the_end();
  for (const std::string& name : hosts_->kill_rest())
    progress_.message("host " + name + ": its agent does not end, killing the command that started it");
  while (!hosts_->all_ended()) turn_at_the_end();
  turn_at_the_end();  // what they wrote last
  remote_traces_.clear();
  result_.hosts = hosts_->summaries();
}

void Runner::end_processes() {
  const double start = result_.wall_seconds;
  const double now = operator_clock_->wall_seconds();
  result_.wall_seconds = task_started_ ? now - start : 0;
  if (result_.ticks == 0 && task_started_) result_.ticks = clock_.tick();
  if (hosts_) guard([this] { hosts_->stop(); });
  end_in_order(crew_, clock_, task_started_,
               {.turn = [this] { turn_at_the_end(); },
                .message = [this](const std::string& line) { progress_.message(line); },
                .failed = [this](const std::string& reason) { fail(process::ExitCode::system, reason); }});
  if (hosts_) guard([this] { end_hosts(); });
  guard([this] { turn(0); });
  if (task_started_) faults_.tell_left();
  progress_.finish();
}

}  // namespace mrroc::cli
