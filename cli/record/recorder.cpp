#include "cli/record/recorder.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <utility>

#include "cli/operator/event_notes.hpp"
#include "core/shown_text.hpp"
#include "messages/mrroc_msgs/event.hpp"
#include "messages/mrroc_msgs/process_end.hpp"
#include "messages/mrroc_msgs/servo_end.hpp"
#include "messages/mrroc_msgs/step.hpp"

namespace mrroc::cli::record {

namespace {

using EventMessage = messages::mrroc_msgs::Event;
using messages::mrroc_msgs::ProcessEnd;
using messages::mrroc_msgs::ServoEnd;

constexpr std::chrono::milliseconds kPause{2};  // of the thread between two looks at the rings
constexpr double kWindow = 0.1;                 // s: under the real clock what is later than this comes out of order

/// The kind of an event, with a final zero.
constexpr const char* kOperator = EventMessage::OPERATOR.data();
constexpr const char* kFault = EventMessage::FAULT.data();

}  // namespace

Recorder::Recorder(const process::ClaimedFile& file, const Recorded& recorded)
    : recorded_(recorded),
      file_(file),
      writer_(file.fd(), recorded.deployment, recorded.text, recorded.last),
      topics_(writer_, recorded.deployment, recorded.servo_ticks),
      fault_taken_(recorded.faults.size(), false) {
  for (const PlannedProcess& process : recorded_.plan) {
    if (!process.has_task) continue;
    Source& source = sources_.emplace(process.name, Source{process.name}).first->second;
    if (process.host.empty()) source.steps.emplace(process::StepRing::create());
  }
  if (recorded_.servo_ticks) {
    servo_topics_.emplace(writer_, recorded_.deployment);
    for (const config::RobotEntry& robot : recorded_.deployment.robots)
      sources_.emplace(robot.edp_process(), Source{robot.edp_process(), robot.name, std::nullopt,
                                                   edp::ServoTap::create(edp::kServoTapName, edp::kServoTapWhat)});
  }
  thread_ = std::thread([this] { run(); });
}

Recorder::~Recorder() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

int Recorder::fd_of(const std::string& process) const noexcept {
  const auto source = sources_.find(process);
  if (source == sources_.end()) return -1;
  if (source->second.steps) return source->second.steps->fd();
  return source->second.servo ? source->second.servo->fd() : -1;
}

void Recorder::take(const config::Event& event) {
  const std::lock_guard lock(mutex_);
  events_.push_back({event.tick, nullptr, Event{kOperator, text_of(event, recorded_.deployment)}});
}

void Recorder::take(const std::string& process, recording::RecordedStep step) {
  const auto source = sources_.find(process);
  if (source == sources_.end()) return;
  const std::lock_guard lock(mutex_);
  const Tick tick = step.tick;
  events_.push_back({tick, &source->second, std::move(step)});
}

void Recorder::take_end(const std::string& process, const recording::StepCounts& counts) {
  const auto source = sources_.find(process);
  const std::lock_guard lock(mutex_);
  if (source != sources_.end()) source->second.counts = counts;
}

void Recorder::run() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    lock.unlock();
    drain(false);
    lock.lock();
    wake_.wait_for(lock, kPause, [this] { return ending_; });
  }
}

void Recorder::drain(bool at_end) {
  // read before the rings: whatever was made before this tick is in them
  const Tick now = recorded_.clock.tick();
  const bool simulated = recorded_.deployment.clock != config::ClockMode::real;
  const Tick window = simulated ? 0 : static_cast<Tick>(std::ceil(kWindow / recorded_.deployment.servo_period));
  // read after the tick: time advances without the tasks, whose last steps are still to come
  const Tick task_end = simulated ? recorded_.clock.task_end() : kNever;
  const Tick before = at_end ? kNever : std::min(now - std::min(now, window), task_end);
  {
    const std::lock_guard lock(mutex_);
    waiting_.insert(waiting_.end(), std::make_move_iterator(events_.begin()), std::make_move_iterator(events_.end()));
    events_.clear();
  }
  take_faults(before);
  for (auto& [name, source] : sources_) {
    while (std::optional<recording::RecordedStep> step = source.steps ? source.steps->take() : std::nullopt)
      waiting_.push_back({step->tick, &source, std::move(*step)});
    for (const edp::ServoSample* sample = nullptr; source.servo && (sample = source.servo->front()) != nullptr;) {
      waiting_.push_back({sample->tick, &source, *sample});
      source.servo->pop();
    }
  }
  // what a servo does after the task depends on the wall clock
  std::erase_if(waiting_, [task_end](const Waiting& waiting) {
    return waiting.tick > task_end && std::holds_alternative<edp::ServoSample>(waiting.content);
  });
  const auto name_of = [](const Source* source) {
    return source == nullptr ? std::string_view{} : std::string_view{source->process};
  };
  const auto earlier = [&name_of](const Waiting& a, const Waiting& b) {
    return std::pair(a.tick, name_of(a.source)) < std::pair(b.tick, name_of(b.source));
  };
  std::stable_sort(waiting_.begin(), waiting_.end(), earlier);
  const auto end =
      std::find_if(waiting_.begin(), waiting_.end(), [before](const Waiting& w) { return w.tick >= before; });
  for (auto one = waiting_.begin(); one != end; ++one) write(*one);
  waiting_.erase(waiting_.begin(), end);
}

void Recorder::take_faults(Tick before) {
  for (std::size_t i = 0; i < fault_taken_.size(); ++i) {
    const Tick tick = recorded_.clock.fault_tick(i);
    if (fault_taken_[i] || tick == kNever || tick >= before) continue;
    fault_taken_[i] = true;
    waiting_.push_back({tick, nullptr, Event{kFault, recorded_.faults[i]}});
  }
}

void Recorder::write(const Waiting& waiting) {
  newest_ = std::max(newest_, waiting.tick);
  if (const Event* const event = std::get_if<Event>(&waiting.content))
    return write_event(waiting.tick, event->kind, event->text, 0);
  Source& source = *waiting.source;
  source.last = waiting.tick;
  if (const auto* const step = std::get_if<recording::RecordedStep>(&waiting.content)) return write_step(source, *step);
  ++source.servo_ticks;
  servo_topics_->write(source.robot, std::get<edp::ServoSample>(waiting.content));
}

void Recorder::write_step(Source& source, const recording::RecordedStep& step) {
  try {
    const auto message = messages::from_cdr<messages::mrroc_msgs::Step>(step.cdr);
    if (message.process != source.process)
      throw messages::CdrError("process '" + core::shown(message.process) + "', expected '" + source.process + "'");
    source.cut += message.cut ? 1 : 0;
    topics_.write(message, step);
  } catch (const messages::CdrError& error) {
    // only a process that writes over its own memory makes such a step
    write_event(step.tick, kFault, "step of " + source.process + ": " + error.what(), 0);
  }
}

void Recorder::write_event(Tick tick, const std::string& kind, const std::string& text, int exit_code) {
  EventMessage event;
  event.stamp = recording::stamp_of(tick, writer_.period());
  event.tick = tick;
  event.kind = kind;
  event.text = text;
  event.exit_code = exit_code;
  writer_.write(recording::kEventTopic, tick, event);
}

void Recorder::write_end(const Source& source) {
  const auto stamp = recording::stamp_of(source.last, writer_.period());
  if ((source.steps && source.steps->ended()) || source.counts) {
    ProcessEnd end;
    end.stamp = stamp;
    end.process = source.process;
    end.steps = source.steps ? source.steps->added() : source.counts->added;
    end.dropped = source.dropped();
    end.cut = source.cut;
    writer_.write(recording::kEndTopic, newest_, end);
  } else if (source.servo && source.servo->ended()) {
    ServoEnd end;
    end.stamp = stamp;
    end.robot = source.robot;
    end.ticks = source.servo_ticks;
    end.dropped = source.dropped();
    writer_.write(recording::kServoEndTopic, newest_, end);
  }
}

int Recorder::close_last(const RunResult& result) {
  const bool own = file_.is_own_regular_file();
  if (result.code != process::ExitCode::success)
    return own && ftruncate(file_.fd(), 0) != 0 ? errno : writer_.save(file_.fd());
  std::error_code none;
  if (own && file_.in_place() && std::filesystem::is_empty(file_.path(), none))
    std::filesystem::remove(file_.path(), none);
  return 0;
}

std::string Recorder::save(const std::filesystem::path& path) const {
  if (writer_.empty()) throw std::logic_error("nothing is recorded yet");
  const std::filesystem::path file = std::filesystem::absolute(path).lexically_normal();
  process::ClaimedFile made = process::ClaimedFile::create(file, "the recording");
  const int problem = writer_.save(made.fd());
  if (problem != 0) {
    std::error_code none;
    std::filesystem::remove(file, none);
    throw std::runtime_error("cannot write the recording " + file.string() + ": " + std::strerror(problem));
  }
  return fmt::format("the last {:g} s; recording: {}", *recorded_.last, file.string());
}

std::string Recorder::close(const RunResult& result) {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
  drain(true);
  for (const auto& [name, source] : sources_) write_end(source);
  write_event(newest_, std::string{EventMessage::END}, result.reason, static_cast<int>(result.code));
  const int problem = writer_.keeps_last() ? close_last(result) : writer_.close();
  const bool left = !writer_.keeps_last() || result.code != process::ExitCode::success;
  if (problem == 0 && left && !file_.in_place() && file_.is_own_regular_file())
    return "cannot write the recording " + file_.path().string() +
           ": another file has taken its place, or it was removed";
  return problem == 0 ? "" : "cannot write the recording " + file_.path().string() + ": " + std::strerror(problem);
}

std::string Recorder::dropped() const {
  std::string text;
  for (const auto& [name, source] : sources_)
    if (source.dropped() != 0)
      text += (text.empty() ? "" : ", ") + std::to_string(source.dropped()) +
              (source.servo ? " ticks of " : " steps of ") + source.process;
  return text;
}

}  // namespace mrroc::cli::record
