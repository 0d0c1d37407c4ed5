#include "process/record/step_reporter.hpp"

#include <algorithm>
#include <array>

#include "process/record/trace_words.hpp"

namespace mrroc::process {

namespace {

void write_vector(TextLine& line, const JointVector& values) noexcept {
  for (Eigen::Index i = 0; i < values.size(); ++i) line << (i == 0 ? "" : ",") << values[i];
}

void write_pose(TextLine& line, const Pose& pose) noexcept {
  const Eigen::Quaterniond rotation(pose.linear());
  const Eigen::Vector3d position = pose.translation();
  line << position.x() << "," << position.y() << "," << position.z() << "," << rotation.w() << "," << rotation.x()
       << "," << rotation.y() << "," << rotation.z();
}

/// A generator may write an invalid value: the EDP refuses it after it has been reported.
constexpr const char* letter_of(AxisBehaviour behaviour) noexcept {
  switch (behaviour) {
    case AxisBehaviour::unguarded:
      return "u";
    case AxisBehaviour::guarded:
      return "g";
    case AxisBehaviour::contact:
      return "c";
  }
  return "?";
}

void write_target(TextLine& line, const RobotCommand& command) noexcept {
  switch (command.kind) {
    case CommandKind::joint:
    case CommandKind::motor:
      write_vector(line << ":", command.joints);
      break;
    case CommandKind::pose:
      write_pose(line << ":", command.pose);
      break;
    case CommandKind::joint_velocity:
      write_vector(line << ":", command.joint_velocity);
      break;
    case CommandKind::twist:
      write_vector(line << ":", command.twist);
      break;
    case CommandKind::force:
      write_vector(line << ":", command.twist);
      for (std::size_t i = 0; i < command.force.behaviour.size(); ++i)
        line << (i == 0 ? "," : "") << letter_of(command.force.behaviour[i]);
      write_vector(line << ",", command.force.wrench);
      break;
    default:
      break;
  }
}

void write_command(TextLine& line, const RobotCommand& command) noexcept {
  line << word_of(kCommandWords, command.kind) << (command.relative ? ",relative" : "");
  if (command.interpolation == Interpolation::motors) line << ",motors";
  if (command.interpolation == Interpolation::task) line << ",task";
  line << ",N" << std::uint64_t{command.motion_steps} << ",v" << std::uint64_t{command.reply_step};
  if (command.start_tick != 0) line << ",start" << command.start_tick;
  write_target(line, command);
}

void write_error(TextLine& line, const ErrorReport& error) noexcept {
  if (error.error_class == ErrorClass::none) return;
  line << " error=\"" << describe(error.error_class) << ": " << describe(error.code) << "\"";
}

void write_robot(TextLine& line, const std::string& name, const RobotState& state) noexcept {
  line << " robot=" << name << " tick=" << state.tick << " macrostep=" << state.macrostep_start << " joints=";
  write_vector(line, state.joints);
  line << " pose=";
  write_pose(line, state.pose);
  line << " desired_tick=" << state.desired_tick << " desired=";
  write_vector(line, state.desired_joints);
  write_pose(line << " desired_pose=", state.desired_pose);
  if (!state.at_rest()) line << " moving";
  if (state.coordination == Coordination::takes_part) line << " coordinated";
  if (state.coordination == Coordination::left) line << " left";
  if (state.late_commands != 0) line << " late=" << std::uint64_t{state.late_commands};
  if (!state.wrench.isZero(0)) write_vector(line << " wrench=", state.wrench);
  if (state.lost != 0) line << " lost=" << state.lost;
  write_error(line, state.error);
}

bool is_polled(const std::string& sensor, const config::Deployment& deployment) noexcept {
  for (const config::SensorEntry& entry : deployment.sensors)
    if (entry.name == sensor) return entry.polled;
  return false;
}

void write_sensor(TextLine& line, const InstructionRecord::SensorEntry& sensor, const SensorReading& reading,
                  const config::Deployment& deployment) noexcept {
  line << " sensor=" << sensor.name << " tick=" << reading.tick << " values=";
  for (std::uint32_t i = 0; i < reading.channel_count; ++i) line << (i == 0 ? "" : ",") << reading.values[i];
  if (sensor.period != 1) line << " period=" << std::uint64_t{sensor.period};
  if (!sensor.interactive) line << " published";
  if (is_polled(sensor.name, deployment)) line << " polled";
  if (reading.configuration != 0) line << " configuration=" << std::uint64_t{reading.configuration};
  if (sensor.configuration != 0) line << " configured=" << std::uint64_t{sensor.configuration};
  write_error(line, reading.error);
}

}  // namespace

void format_step(TextLine& line, const config::Deployment& deployment, std::string_view process,
                 const StepRecord& record) noexcept {
  const InstructionRecord& instruction = *record.instruction;
  line << "tick=" << record.tick << " process=" << process << " instruction=" << instruction.number
       << (instruction.is_move ? " move=\"" : " wait=\"") << instruction.name << "\"";
  if (instruction.until) line << " until=\"" << *instruction.until << "\"";
  line << " step=" << record.step;
  if (record.held != 0) line << " held=" << record.held;
  if (record.obtained) line << " obtained";
  for (std::size_t i = 0; i < record.states.size(); ++i) {
    write_robot(line, instruction.robots[i], record.states[i]);
    if (!record.last()) write_command(line << " command=", record.commands[i]);
    if (record.superior) write_command(line << " superior=", *record.superior);
  }
  for (std::size_t i = 0; i < record.readings.size(); ++i)
    write_sensor(line, instruction.sensors[i], record.readings[i], deployment);
  for (std::size_t i = 0; i < record.conditions.size(); ++i)
    line << " condition=\"" << instruction.conditions[i] << "\":" << (record.conditions[i] != 0 ? "1" : "0");
  if (record.last()) line << " end=" << word_of(kEndingWords, record.ending);
  if (record.last() && record.states.size() > 1) line << " skew=" << record.skew;
}

StepReporter::StepReporter(Process& process) : process_(process) {
  if (const int fd = process.arguments().black_box_fd; fd >= 0) last_steps_.emplace(SharedBlackBox::attach(fd));
  const Arguments& arguments = process.arguments();
  if (arguments.record_fd >= 0) ring_.emplace(StepRing::attach(arguments.record_fd));
  if (arguments.trace_fd >= 0)
    trace_ =
        std::make_unique<TraceFile>(arguments.trace_fd, arguments.trace, process.name(), process.clock().simulated());
}

StepReporter::~StepReporter() {
  if (ring_) ring_->end();
  if (trace_ == nullptr) return;
  if (const std::string problem = trace_->close(); !problem.empty()) process_.fail_at_end(problem);
}

void StepReporter::on_step(const StepRecord& record) noexcept {
  process_.faults().count_step(process_.name(), ++steps_, process_.clock().tick(), process_.clock());
  process_.status().step(record.instruction->number, record.instruction->name, record.step);
  if (record.states.size() > 1 && !record.last()) {
    ++counters_.common_steps;
    counters_.skew_ticks = std::max<std::uint64_t>(counters_.skew_ticks, record.skew);
    process_.status().counters(counters_);
  }
  if (last_steps_ || trace_ != nullptr || ring_) write_line(record);
}

void StepReporter::write_line(const StepRecord& record) noexcept {
  line_.clear();
  format_step(line_, process_.deployment(), process_.name(), record);
  if (last_steps_) last_steps_->record(line_);
  if (ring_) ring_->add(process_.clock().tick(), line_, process_.clock().simulated());
  if (trace_ == nullptr) return;
  if (TextLine* const next = trace_->begin(); next != nullptr) {
    *next = line_;
    trace_->commit();
  }
}

}  // namespace mrroc::process
