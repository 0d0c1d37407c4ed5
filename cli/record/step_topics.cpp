#include "cli/record/step_topics.hpp"

#include <utility>

#include "cli/record/standard_messages.hpp"

namespace mrroc::cli::record {

namespace {

constexpr std::size_t kWrenchSize = 6;

}  // namespace

StepTopics::StepTopics(recording::RecordingWriter& file, const config::Deployment& deployment, bool servo_ticks)
    : file_(file), joint_states_(!servo_ticks) {
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (sensor.gives_wrench) wrench_sensors_.insert(sensor.name);
  for (const config::RobotEntry& robot : deployment.robots) joints_.emplace(robot.name, joint_names(robot));
}

void StepTopics::write(const messages::mrroc_msgs::Step& step, recording::RecordedStep recorded) {
  const Tick tick = recorded.tick;
  file_.write_step(step.process, tick, std::move(recorded.cdr));
  for (const messages::mrroc_msgs::RobotState& robot : step.robots) write_robot(robot, tick);
  for (const messages::mrroc_msgs::SensorReading& sensor : step.sensors)
    if (wrench_sensors_.contains(sensor.name) && sensor.error_class == messages::mrroc_msgs::RobotState::NO_ERROR)
      write_wrench(sensor.name, sensor.name, sensor.values, sensor.tick, tick);
}

void StepTopics::write_robot(const messages::mrroc_msgs::RobotState& robot, Tick tick) {
  const std::string topic = joint_topic(robot.name);
  if (joint_states_ && is_new(topic, robot.tick)) {
    messages::sensor_msgs::JointState message;
    message.header.stamp = recording::stamp_of(robot.tick, file_.period());
    if (const auto names = joints_.find(robot.name); names != joints_.end()) message.name = names->second;
    message.position = robot.joints;
    file_.write(topic, tick, message);
  }
  if (!robot.wrench.empty()) write_wrench(robot.name, tool_frame(robot.name), robot.wrench, robot.tick, tick);
}

void StepTopics::write_wrench(const std::string& name, const std::string& frame, const std::vector<double>& values,
                              Tick measured, Tick tick) {
  const std::string topic = wrench_topic(name);
  if (values.size() < kWrenchSize || !is_new(topic, measured)) return;
  const std::span<const double, kWrenchSize> wrench(values.data(), kWrenchSize);
  file_.write(topic, tick, to_wrench(frame, recording::stamp_of(measured, file_.period()), wrench));
}

bool StepTopics::is_new(const std::string& topic, Tick measured) {
  const auto [known, added] = newest_.emplace(topic, measured);
  if (!added && known->second >= measured) return false;
  known->second = measured;
  return true;
}

}  // namespace mrroc::cli::record
