#include "process/task_process.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "mrroc/stopped.hpp"
#include "process/record/black_box_file.hpp"
#include "process/record/text_memory.hpp"

namespace mrroc::process {

namespace {

/// As the runner has read it; on another host, as the process has.
std::string deployment_text(const Arguments& arguments) {
  if (arguments.deployment_fd >= 0) return read_text(arguments.deployment_fd);
  std::ifstream file(arguments.deployment);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string names_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

template <class Entry>
const Entry& find_entry(const std::vector<Entry>& entries, const std::string& name, const std::string& type,
                        const char* kind, const std::string& process) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) {
    names.push_back(entry.name);
    if (entry.name != name) continue;
    if (entry.type == type) return entry;
    std::string text = kind;
    text.append(" '").append(name).append("' is of type '").append(entry.type);
    text.append("' in the deployment, the task expects '").append(type).append("'");
    throw NonFatalError(ErrorCode::invalid_argument, text, {process, name, 0, 0});
  }
  throw NonFatalError(ErrorCode::invalid_argument,
                      std::string{"the deployment has no "} + kind + " '" + name + "', it has: " + names_of(names),
                      {process, name, 0, 0});
}

}  // namespace

TaskProcess::TaskProcess(Process& process, const std::string& superior_topic)
    : process_(process),
      task_link_(process.domain(), process.clock(), superior_topic),
      dialogue_(process),
      trajectories_(process),
      reporter_(std::make_unique<StepReporter>(process)) {}

TaskProcess::~TaskProcess() = default;

std::filesystem::path TaskProcess::robot_parameters(const std::string& name, const std::string& type) const {
  for (const config::RobotEntry& robot : process_.deployment().robots) {
    if (robot.name != name) continue;
    if (type.empty()) return robot.files().parameters;
    if (robot.type == type) return robot.parameters;
  }
  return {};
}

Load TaskProcess::robot_load(const std::string& name) const {
  for (const config::RobotEntry& robot : process_.deployment().robots)
    if (robot.name == name) return robot.load;
  return {};
}

MeasuredArm TaskProcess::measured_arm(const std::string& name) const {
  for (const config::RobotEntry& robot : process_.deployment().robots)
    if (robot.name == name) return robot.measured_arm;
  return {};
}

RobotLink& TaskProcess::robot_link(const std::string& name, const std::string& type) {
  find_entry(process_.deployment().robots, name, type, "robot", process_.name());
  if (!robots_.contains(name)) {
    check_not_started("robot", name);
    const auto& link = robots_[name] = std::make_unique<links::RobotRequester>(
        process_.domain(), process_.clock(), robot_topic(name), robot_peer(name), patience());
    if (auto faults = process_.faults().of(process_.name(), process_.clock()); !faults.empty())
      faulty_.try_emplace(name, *link, std::move(faults), process_.clock(), patience());
  }
  if (const auto faulty = faulty_.find(name); faulty != faulty_.end()) return faulty->second;
  return *robots_.at(name);
}

SensorLink& TaskProcess::sensor_link(const std::string& name, const std::string& type, bool& interactive) {
  const config::SensorEntry& entry = find_entry(process_.deployment().sensors, name, type, "sensor", process_.name());
  interactive = entry.interactive;
  if (!sensors_.contains(name)) {
    check_not_started("sensor", name);
    links::SensorRequesterOptions options;
    options.published = !entry.interactive;
    options.polled = entry.polled;
    options.timeout = patience();
    sensors_[name] = std::make_unique<links::SensorRequester>(process_.domain(), process_.clock(), process_.topic(name),
                                                              process_.name(), name, options);
  }
  return *sensors_.at(name);
}

void TaskProcess::check_not_started(const char* kind, const std::string& name) const {
  if (!connected_) return;
  throw NonFatalError(ErrorCode::invalid_argument,
                      std::string{kind} + " '" + name +
                          "' is made while the task runs, expected a member of the task class or an object made in "
                          "its constructor: links are opened before the start",
                      {process_name(), name, 0, tick()});
}

Tick TaskProcess::patience() const {
  return static_cast<Tick>(std::llround(process_.deployment().heartbeat_timeout / servo_period()));
}

void TaskProcess::connect_links() {
  connected_ = true;
  const double timeout = process_.deployment().start_timeout;
  for (auto& [name, link] : robots_) link->connect(timeout);
  for (auto& [name, link] : sensors_) link->connect(timeout);
  dialogue_.connect(timeout);
  trajectories_.connect(timeout);
}

void TaskProcess::await_published_sensors() {
  const auto patience = static_cast<Tick>(std::llround(1.0 / servo_period()));
  const Tick until = tick() + patience;
  for (auto& [name, link] : sensors_)
    if (!process_.deployment().sensor(name).interactive) link->await_published(until);
}

bool TaskProcess::read_superior() {
  bool started = false;
  links::TaskCommand command;
  while (task_link_.take(command)) {
    switch (command.kind) {
      case links::TaskCommandKind::start:
        started = true;
        started_ = command.parcel;
        running_ = true;  // the messages that follow are for the starting program
        mailbox_.clear();
        request_ = OperatorRequest::none;
        break;
      case links::TaskCommandKind::pause:
        if (request_ == OperatorRequest::none) request_ = OperatorRequest::pause;
        break;
      case links::TaskCommandKind::resume:
        if (request_ == OperatorRequest::pause) request_ = OperatorRequest::none;
        break;
      case links::TaskCommandKind::stop:
        request_ = OperatorRequest::stop;
        break;
      case links::TaskCommandKind::end_motion:
        if (request_ != OperatorRequest::stop) request_ = OperatorRequest::end_motion;
        break;
      case links::TaskCommandKind::trigger:
        ++triggers_;
        break;
      case links::TaskCommandKind::message:
        if (running_) mailbox_.put(command.parcel);
        break;
      case links::TaskCommandKind::speed:
        if (command.speed > 0 && command.speed <= 1) speed_ = command.speed;
        break;
    }
    on_superior_command(command);
  }
  return started;
}

void TaskProcess::report(links::TaskState state) {
  running_ = state == links::TaskState::running;
  links::TaskStatus status;
  status.state = state;
  status.tick = tick();
  task_link_.report(status);
}

void TaskProcess::report_failure(const std::exception& error) {
  running_ = false;
  const auto* known = dynamic_cast<const Error*>(&error);
  std::fprintf(stderr, "%s%s\n", error.what(), save_black_box(known).c_str());
  const ErrorOrigin origin = known != nullptr ? known->origin() : ErrorOrigin{};
  links::TaskStatus status;
  status.state = links::TaskState::failed;
  status.error = report_of(error);
  status.process.assign(origin.process.empty() ? process_name() : origin.process);
  status.device.assign(origin.device);
  status.step = origin.step;
  status.tick = tick();
  status.error_tick = origin.tick != 0 ? origin.tick : status.tick;
  task_link_.report(status);
}

std::string TaskProcess::save_black_box(const Error* error) const try {
  const BlackBox& box = error != nullptr && error->black_box() != nullptr ? *error->black_box() : black_box();
  const std::filesystem::path& folder = process_.arguments().black_box;
  if (folder.empty() || box.empty()) return "";
  const config::Deployment& deployment = process_.deployment();
  const std::uint64_t number =
      write_black_box(folder, encoded(box, deployment, process_name()), deployment,
                      deployment_text(process_.arguments()), process_name(), process_.clock().simulated());
  if (const int fd = process_.arguments().black_box_fd; fd >= 0) SharedBlackBox::attach(fd).note_file(number);
  return "; black box: " + black_box_path(folder, process_.deployment(), process_name(), number).string();
} catch (const std::exception& failure) {
  return std::string{"; "} + failure.what();
}

void TaskProcess::sleep_until(Tick tick) {
  while (process_.clock().tick() < tick) {
    if (process_.clock().wait(tick) == clock::Wake::interrupted) throw Stopped{};
  }
}

OperatorRequest TaskProcess::operator_request() {
  read_superior();
  poll_others();
  if (process_.fibers() != nullptr && process_.fibers()->cancelled()) return OperatorRequest::stop;
  if (request_ != OperatorRequest::end_motion) return request_;
  request_ = OperatorRequest::none;  // it ends one motion only
  return OperatorRequest::end_motion;
}

bool TaskProcess::may_go_on() {
  const OperatorRequest request = operator_request();
  if (request == OperatorRequest::stop) throw Stopped{};
  return request != OperatorRequest::pause;
}

void TaskProcess::wait_until(const std::function<bool()>& holds) {
  FiberScheduler* const fibers = process_.fibers();
  if (fibers != nullptr) fibers->note_progress();
  for (;;) {  // check before waiting: earlier messages do not wake the thread
    if (may_go_on() && holds()) {
      if (fibers != nullptr) fibers->note_progress();
      return;
    }
    if (process_.clock().wait(kNever) == clock::Wake::interrupted) throw Stopped{};
  }
}

bool TaskProcess::ask_yes_no(const std::string& question) {
  links::OperatorQuestion asked;
  asked.kind = links::QuestionKind::yes_no;
  return put_question(asked, question) != 0;
}

std::size_t TaskProcess::ask_choice(const std::string& question, const std::vector<std::string>& choices) {
  links::OperatorQuestion asked;
  asked.kind = links::QuestionKind::choice;
  if (choices.empty() || choices.size() > asked.choices.size()) {
    throw NonFatalError(ErrorCode::invalid_argument, std::to_string(choices.size()) + " choices of '" + question +
                                                         "', expected 1 to " + std::to_string(asked.choices.size()));
  }
  asked.choice_count = static_cast<std::uint8_t>(choices.size());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    asked.choices[i].assign(choices[i]);
    if (choices[i].empty() || asked.choices[i].view() != choices[i])
      throw NonFatalError(ErrorCode::invalid_argument,
                          "the choice '" + choices[i] + "' of '" + question + "', expected 1 to 31 characters");
  }
  return static_cast<std::size_t>(put_question(asked, question));
}

double TaskProcess::ask_number(const std::string& question, double minimum, double maximum) {
  links::OperatorQuestion asked;
  asked.kind = links::QuestionKind::number;
  asked.minimum = minimum;
  asked.maximum = maximum;
  return put_question(asked, question);
}

double TaskProcess::put_question(links::OperatorQuestion question, const std::string& text) {
  return dialogue_.ask(question, text, [this] { return may_go_on(); });
}

bool TaskProcess::take_trigger() {
  read_superior();
  if (triggers_ == 0) return false;
  --triggers_;
  return true;
}

}  // namespace mrroc::process
