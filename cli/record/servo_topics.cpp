#include "cli/record/servo_topics.hpp"

#include <algorithm>
#include <cmath>

#include "cli/record/standard_messages.hpp"
#include "messages/mrroc_msgs/servo_tick.hpp"

namespace mrroc::cli::record {

namespace {

using messages::mrroc_msgs::ServoTick;

// the numbers of the messages are those of the enumeration, which a recording must not follow when they change
static_assert(ServoTick::OFF == static_cast<int>(edp::ServoState::off));
static_assert(ServoTick::STOPPING == static_cast<int>(edp::ServoState::stopping));

constexpr double kLongest = 1e9;  // ticks: a later time of a measurement is not one

messages::builtin_interfaces::Time measured_at(const edp::ServoSample& sample, std::uint64_t period) {
  const bool known = sample.measured >= 0 && sample.measured < kLongest;
  const double ticks = known ? sample.measured : 0;
  return recording::stamp_at(static_cast<std::uint64_t>(std::llround(ticks * static_cast<double>(period))));
}

}  // namespace

ServoTopics::ServoTopics(recording::RecordingWriter& file, const config::Deployment& deployment) : file_(file) {
  for (const config::RobotEntry& robot : deployment.robots)
    robots_[robot.name] = {joint_names(robot), robot.force_sensor};
}

void ServoTopics::write(const std::string& name, const edp::ServoSample& sample) {
  const Robot& robot = robots_.at(name);
  const std::size_t axes = std::min<std::size_t>(sample.axes, sample.joints.size());
  const auto values = [axes](const edp::ServoSample::Values& of) {
    return std::vector<double>(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(axes));
  };

  ServoTick tick;
  tick.stamp = measured_at(sample, file_.period());
  tick.tick = sample.tick;
  tick.ahead = sample.ahead;
  tick.joints = values(sample.joints);
  tick.velocity = values(sample.velocity);
  tick.desired_joints = values(sample.desired_joints);
  tick.motors = values(sample.motors);
  tick.desired_motors = values(sample.desired_motors);
  tick.current = values(sample.current);
  tick.commanded_current = values(sample.commanded_current);
  if (!robot.force_sensor.empty()) tick.wrench.assign(sample.wrench.begin(), sample.wrench.end());
  tick.digital_inputs = sample.inputs.digital;
  tick.digital_outputs = sample.outputs.digital;
  tick.analog_inputs.assign(sample.inputs.analog.begin(), sample.inputs.analog.end());
  tick.analog_outputs.assign(sample.outputs.analog.begin(), sample.outputs.analog.end());
  tick.state = static_cast<std::uint8_t>(sample.state);
  if (sample.fault != ErrorCode::none) tick.fault = describe(sample.fault);
  tick.fault_axis = sample.fault_axis;
  file_.write("/" + name + "/servo", sample.tick, tick);

  messages::sensor_msgs::JointState state;
  state.header.stamp = tick.stamp;
  if (robot.joints.size() == axes) state.name = robot.joints;
  state.position = tick.joints;
  state.velocity = tick.velocity;
  file_.write(joint_topic(name), sample.tick, state);

  if (!robot.force_sensor.empty())
    file_.write("/" + name + "/servo_wrench", sample.tick, to_wrench(robot.force_sensor, tick.stamp, sample.wrench));
}

}  // namespace mrroc::cli::record
