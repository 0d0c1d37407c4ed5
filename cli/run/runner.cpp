#include "cli/run/runner.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <utility>

#include "cli/processes/launch.hpp"
#include "cli/processes/resource_limits.hpp"
#include "cli/run/clock_options.hpp"
#include "cli/run/report.hpp"
#include "cli/run/run_result.hpp"
#include "cli/run/shutdown.hpp"
#include "clock/wall/realtime.hpp"
#include "config/network/ros2_entry.hpp"
#include "config/resources.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::cli {

namespace {

constexpr int kHighestPriority = 81;            // of a servo thread under SCHED_FIFO
constexpr double kHandShake = 0.1;              // s of one attempt to reach the MP
constexpr double kEndTimeoutAfterSuccess = 10;  // s: on a busy machine the kernel takes seconds to end a process

/// The processes of one host; "": of this machine.
std::vector<PlannedProcess> processes_on(const std::string& host, const std::vector<PlannedProcess>& plan) {
  std::vector<PlannedProcess> found;
  for (const PlannedProcess& process : plan)
    if (process.host == host) found.push_back(process);
  return found;
}

/// The text, when the limits of this process allow what a run needs.
const std::string& within_limits(const std::vector<PlannedProcess>& plan, const RunOptions& options) {
  const std::size_t recorded = options.recording.empty()    ? 0
                               : options.record_servo_ticks ? edp::ServoTap::memory_size()
                                                            : process::StepRing::memory_size();
  check_limits(processes_on("", plan).size(), recorded);
  return options.text;
}

/// Nothing when there is no bridge.
std::optional<int> domain_of_ros2(const config::Deployment& deployment, const RunOptions& options) {
  if (!deployment.ros2 && !options.ros2) return std::nullopt;
  return config::ros2_domain(deployment.ros2.value_or(config::Ros2Entry{}));
}

std::string bridge_program() {
  if (const std::filesystem::path program = config::find_program("mrroc_ros2"); !program.empty()) return program;
  throw std::runtime_error("the bridge to ROS 2 is not installed here, expected mrroc_ros2");
}

}  // namespace

Runner::Runner(const config::Deployment& deployment, RunOptions options)
    : deployment_(deployment),
      options_(std::move(options)),
      plan_(plan_processes(deployment_)),
      text_(within_limits(plan_, options_)),
      black_boxes_(options_.black_box, deployment_, options_.text, plan_),
      cameras_(deployment_, plan_),
      progress_(names_of(plan_), deployment_.servo_period, options_.quiet, descriptor_for_progress(options_.recording)),
      domain_lock_(deployment_.domain, domain_of_ros2(deployment_, options_)),
      clock_(clock_options(deployment_, names_of(processes_on("", plan_)))),
      operator_clock_(clock_.operator_clock()),
      group_([this](const std::string& name, const std::string& line) { progress_.message(name + " | " + line); }),
      faults_(options_.faults, plan_, deployment_, clock_, group_, deployment_.clock != config::ClockMode::real,
              [this](const std::string& line) { progress_.message(line); }),
      service_(deployment_),
      supervisor_({deployment_, plan_, clock_, *operator_clock_, group_, faults_, black_boxes_, progress_, service_}),
      input_(options_.attended ? STDIN_FILENO : -1, progress_.live()) {
  if (deployment_.sim && deployment_.sim->host.empty())
    world_ = std::make_unique<world::MappedWorld>(world::MappedWorld::create());
}

Runner::~Runner() {
  clock_.end();
  clock_.join();  // its events use the links
}

process::ExitCode Runner::run() {
  check_somebody_answers(deployment_, input_.attended() || options_.panel.has_value());
  if (const std::string warning = check_network(deployment_.network); !warning.empty()) progress_.error(warning);
  if (deployment_.clock == config::ClockMode::real)
    if (const std::string refused = clock::refused_realtime(kHighestPriority); !refused.empty())
      progress_.message("warning: " + refused + " refused: ticks may come late (RLIMIT_RTPRIO, RLIMIT_MEMLOCK)");
  check_black_boxes();
  // before anything is started: a run without its outputs would be useless
  bool waits = false;
  Outputs outputs(options_, deployment_, [&](int milliseconds) {
    if (!std::exchange(waits, true))
      progress_.message("waiting for a reader of the recording " + options_.recording.string());
    return supervisor_.turn(milliseconds);
  });
  if (!supervisor_.ending()) outputs.begin();
  // before the run is confined to one CPU: its thread is not part of the deployment
  if (outputs.recording() != nullptr && !supervisor_.ending())
    recorder_.emplace(*outputs.recording(),
                      record::Recorder::Recorded{deployment_, plan_, options_.text, options_.faults, clock_,
                                                 options_.record_servo_ticks, options_.record_last});
  open_operator(outputs);
  open_sides();
  // lockstep is serial by nature: one CPU for all is several times faster than two
  if (deployment_.clock != config::ClockMode::real) clock::pin_to_one_cpu();
  supervisor_.guard([&] {
    if (!supervisor_.ending()) start_processes(outputs);
    if (!supervisor_.ending()) pass_barrier();
    if (!supervisor_.ending()) supervisor_.supervise();
  });
  end_processes();
  // a failed task has written its own; this writes those of tasks that died or were ended because of it
  if (supervisor_.result().code == process::ExitCode::system)
    if (const std::string line = black_boxes_.save_rest(); !line.empty()) progress_.message(line);
  close_recording(outputs);
  RunResult result = supervisor_.result();
  if (hosts_) result.hosts = hosts_->summaries();
  if (!options_.quiet) progress_.message(report_of(deployment_, result));
  service_.end(static_cast<int>(result.code), result.reason);
  return result.code;
}

/// Without its socket a run can still be operated at its own terminal.
void Runner::open_operator(const Outputs& outputs) {
  if (outputs.notes() >= 0) {
    notes_.emplace(outputs.notes(), options_.note_events, deployment_);
    service_.note_to([this](const config::Event& event) { notes_->note(event); });
  }
  service_.record_with([this](const std::string& file) {
    return recorder_ && recorder_->keeps_last() ? recorder_->save(file) : black_boxes_.record(file);
  });
  service_.show_cameras(cameras_.files());
  service_.end_with([this] { supervisor_.fail(process::ExitCode::stopped, "ended by the operator"); });
  progress_.listen([this](const std::string& text) { service_.message(text); });
  try {
    supervisor_.watch(socket_.emplace(service_, deployment_.name));
  } catch (const std::runtime_error& error) {
    progress_.error(std::string{"mrroc: other terminals cannot operate this run: "} + error.what());
  }
  service_.publish_to([this](const std::string& json, const std::string& text) {
    if (socket_) socket_->publish(json);
    if (!text.empty()) progress_.notice("operator: " + text);
  });
}

void Runner::open_sides() {
  supervisor_.guard([this] {
    if (options_.panel) open_side("panel", panel_program(), panel_arguments(*options_.panel));
    if (deployment_.ros2 || options_.ros2) open_side("ros2", bridge_program(), {});
  });
}

void Runner::open_side(const std::string& name, const std::string& program, std::vector<std::string> words) {
  if (supervisor_.ending()) return;
  if (!socket_) throw std::runtime_error("without the operator's socket there is no process '" + name + "'");
  // its lines may contain a right to command, as the panel's URL: clients of the socket do not see them
  SideProcess& side = sides_.emplace_back(name, program, std::move(words), socket_->path(),
                                          [this](const std::string& line) { progress_.notice(line); });
  supervisor_.watch(side);
  while (!side.started())
    if (!supervisor_.turn(Supervisor::kTurn)) return;
  if (side.ended()) supervisor_.fail(process::ExitCode::usage, side.last_line());
}

void Runner::start_processes(Outputs& outputs) {
  // a program in another folder finds the others and the data files where the runner does
  config::hand_down_directories();
  std::vector<PlannedProcess> order = plan_;
  std::mt19937_64 random(options_.shuffle_seed.value_or(0));
  if (options_.shuffle_seed) std::shuffle(order.begin(), order.end(), random);
  hosts_ = std::make_unique<RemoteHosts>(deployment_, host_listener(), operator_clock_->emergency_stop());
  supervisor_.watch(*hosts_);
  hosts_->start_agents(common_order());
  const Surroundings surroundings{.deployment = deployment_,
                                  .options = options_,
                                  .outputs = outputs,
                                  .black_boxes = black_boxes_,
                                  .cameras = cameras_,
                                  .recorder = recorder_ ? &*recorder_ : nullptr,
                                  .domain = domain_lock_.domain(),
                                  .own_address = hosts_->own_address(),
                                  .peers = hosts_->machines(),
                                  .deployment_fd = text_.fd(),
                                  .clock_fd = clock_.fd(),
                                  .world_fd = world_ ? world_->fd() : -1};
  for (const PlannedProcess& process : order) {
    if (!process.host.empty()) continue;
    if (options_.shuffle_seed && !supervisor_.turn(static_cast<int>(random() % 300))) return;
    const process::Arguments arguments = arguments_for(process, surroundings);
    group_.start(process, process::to_command_line(arguments), arguments.descriptors());
  }
  const auto show = [this](const std::string& line) { progress_.message(line); };
  links_ = std::make_unique<RunLinks>(deployment_, domain_options(surroundings), clock_, *operator_clock_,
                                      world_ ? &**world_ : nullptr, show);
  console_.emplace(service_, links_->questions, input_, show);
  supervisor_.watch(*links_, *console_);
}

void Runner::pass_barrier() {
  const double deadline = operator_clock_->wall_seconds() + deployment_.start_timeout;
  std::vector<std::string> missing;
  while (!(missing = not_ready()).empty()) {
    if (!supervisor_.turn(Supervisor::kTurn)) return;
    if (operator_clock_->wall_seconds() > deadline) {
      not_ready_in_time(fmt::format("{}", fmt::join(missing, ", ")));
      return;
    }
  }
  if (!connect_to_mp(deadline)) return;
  links_->events.emergency_stop_arrives_when([this] { return hosts_->follow_emergency_stop(); });
  if (recorder_) links_->events.report_to([this](const config::Event& event) { recorder_->take(event); });
  links_->events.schedule(deployment_, options_.hold);
  service_.connect(links_->events, links_->questions, links_->robots, links_->trajectories);
  faults_.schedule();
  supervisor_.task_starts();
  clock_.start(hosts_->start());
}

HostListener Runner::host_listener() {
  HostListener listener;
  listener.message = [this](const std::string& line) { progress_.message(line); };
  listener.lost = [this](const std::string& name, int exit_code, const std::string& how) {
    supervisor_.process_lost(name, exit_code, how);
  };
  listener.failed = [this](process::ExitCode code, const std::string& reason) { supervisor_.fail(code, reason); };
  listener.step = [this](const std::string& name, recording::RecordedStep step) {
    if (recorder_) recorder_->take(name, std::move(step));
  };
  listener.steps_end = [this](const std::string& name, const recording::StepCounts& counts) {
    if (recorder_) recorder_->take_end(name, counts);
  };
  listener.last_step = [this](const std::string& name, recording::RecordedStep step) {
    black_boxes_.take(name, std::move(step));
  };
  return listener;
}

AgentOrder Runner::common_order() const {
  AgentOrder order;
  order.domain = domain_lock_.domain();
  order.record = recorder_.has_value();
  order.black_box = !options_.black_box.empty();
  if (!options_.motion.empty()) order.motion = std::filesystem::absolute(options_.motion);
  return order;
}

std::vector<std::string> Runner::not_ready() {
  std::vector<std::string> missing = clock_.wait_ready(0);
  const std::vector<std::string> elsewhere = hosts_->missing();
  missing.insert(missing.end(), elsewhere.begin(), elsewhere.end());
  // with keys, a process may be ready before this one has finished its own hand-shake with it
  if (missing.empty()) missing = supervisor_.without_status();
  return missing;
}

bool Runner::connect_to_mp(double deadline) {
  for (;;) {
    try {
      links_->mp.connect(kHandShake);
      links_->robots.connect(kHandShake);
      return true;
    } catch (const SystemError& error) {
      if (error.code() != ErrorCode::link_lost) throw;
      if (operator_clock_->wall_seconds() > deadline) {
        not_ready_in_time(error.what());
        return false;
      }
    }
    if (!supervisor_.turn(0)) return false;
  }
}

void Runner::not_ready_in_time(const std::string& missing) {
  supervisor_.fail(process::ExitCode::system,
                   fmt::format("not ready within {} s: {}", deployment_.start_timeout, missing));
}

void Runner::end_processes() {
  supervisor_.task_ends();
  const ShutdownListener listener{
      .turn = [this] { supervisor_.turn_at_the_end(); },
      .message = [this](const std::string& line) { progress_.message(line); },
      .failed = [this](const std::string& reason) { supervisor_.fail(process::ExitCode::system, reason); },
      .end_timeout = supervisor_.result().code == process::ExitCode::success ? kEndTimeoutAfterSuccess : kEndTimeout,
      .hurried = [this] { return supervisor_.hurried(); }};
  if (hosts_) supervisor_.guard([this] { hosts_->stop(); });
  shut_down(group_, clock_, supervisor_.task_started(), listener);
  if (hosts_) supervisor_.guard([&] { shut_down(*hosts_, listener); });
  supervisor_.guard([this] { supervisor_.turn(0); });
  if (supervisor_.task_started()) faults_.tell_left();
  progress_.finish();
}

}  // namespace mrroc::cli
