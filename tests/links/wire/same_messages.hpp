#pragma once

#include <cstring>

#include "links/wire/operator_messages.hpp"
#include "links/wire/process_status.hpp"
#include "links/wire/task_messages.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/sensor_link.hpp"

/// Bitwise equality of two messages.
namespace mrroc::links {

template <class Matrix>
bool same_matrix(const Matrix& a, const Matrix& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}
inline bool same(const ErrorReport& a, const ErrorReport& b) {
  return a.error_class == b.error_class && a.code == b.code && a.detail == b.detail;
}
inline bool same(const RobotCommand& a, const RobotCommand& b) {
  return a.kind == b.kind && a.relative == b.relative && a.motion_steps == b.motion_steps &&
         a.reply_step == b.reply_step && a.start_tick == b.start_tick && same_matrix(a.joints, b.joints) &&
         same_matrix(a.joint_velocity, b.joint_velocity) && same_matrix(a.joint_acceleration, b.joint_acceleration) &&
         same_matrix(a.pose.matrix(), b.pose.matrix()) && same_matrix(a.twist, b.twist) &&
         a.interpolation == b.interpolation && same_matrix(a.twist_acceleration, b.twist_acceleration) &&
         a.choice == b.choice && a.stop.ticks == b.stop.ticks && a.stop.group == b.stop.group &&
         same_matrix(Eigen::Matrix<double, 1, 1>(a.stop.rate), Eigen::Matrix<double, 1, 1>(b.stop.rate)) &&
         same_matrix(Eigen::Matrix<double, 1, 1>(a.load.mass), Eigen::Matrix<double, 1, 1>(b.load.mass)) &&
         same_matrix(a.load.centre, b.load.centre) && a.with_outputs == b.with_outputs && a.outputs == b.outputs &&
         a.force.behaviour == b.force.behaviour && same_matrix(a.force.wrench, b.force.wrench) &&
         same_matrix(a.force.inertia, b.force.inertia) && same_matrix(a.force.admittance, b.force.admittance);
}
inline bool same(const RobotState& a, const RobotState& b) {
  return a.tick == b.tick && same_matrix(a.joints, b.joints) && same_matrix(a.joint_velocity, b.joint_velocity) &&
         same_matrix(a.motors, b.motors) && same_matrix(a.current, b.current) &&
         same_matrix(a.pose.matrix(), b.pose.matrix()) && a.desired_tick == b.desired_tick &&
         same_matrix(a.desired_joints, b.desired_joints) && same_matrix(a.desired_velocity, b.desired_velocity) &&
         same_matrix(a.desired_acceleration, b.desired_acceleration) &&
         same_matrix(a.desired_pose.matrix(), b.desired_pose.matrix()) && a.synchronised == b.synchronised &&
         a.enabled == b.enabled && a.coordination == b.coordination && a.late_commands == b.late_commands &&
         same(a.error, b.error) && a.macrostep_start == b.macrostep_start && a.model == b.model &&
         same_matrix(a.tool.matrix(), b.tool.matrix()) && same_matrix(a.wrench, b.wrench) && a.lost == b.lost &&
         a.inputs == b.inputs && a.outputs == b.outputs && a.regulators == b.regulators;
}
inline bool same(const Message& a, const Message& b) {
  return a.label == b.label && a.fingerprint == b.fingerprint && a.size == b.size && a.content == b.content;
}
inline bool same(const SensorRequest& a, const SensorRequest& b) {
  return a.kind == b.kind && a.measure_at == b.measure_at && same(a.configuration, b.configuration);
}
inline bool same(const SensorReading& a, const SensorReading& b) {
  return a.sequence == b.sequence && a.tick == b.tick && a.configuration == b.configuration &&
         a.channel_count == b.channel_count && std::memcmp(a.values.data(), b.values.data(), sizeof a.values) == 0 &&
         same(a.error, b.error);
}
inline bool same(const TaskCommand& a, const TaskCommand& b) {
  return a.kind == b.kind && same(a.parcel, b.parcel) && std::memcmp(&a.speed, &b.speed, sizeof a.speed) == 0;
}
inline bool same(const TaskStatus& a, const TaskStatus& b) {
  return a.state == b.state && same(a.error, b.error) && a.process == b.process && a.device == b.device &&
         a.step == b.step && a.error_tick == b.error_tick && a.tick == b.tick && same(a.parcel, b.parcel);
}
inline bool same(const OperatorQuestion& a, const OperatorQuestion& b) {
  const auto same_number = [](double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return a.text == b.text && a.kind == b.kind && same_number(a.minimum, b.minimum) &&
         same_number(a.maximum, b.maximum) && a.choice_count == b.choice_count && a.choices == b.choices &&
         a.tick == b.tick;
}
inline bool same(const OperatorAnswer& a, const OperatorAnswer& b) {
  return a.question == b.question && std::memcmp(&a.value, &b.value, sizeof a.value) == 0;
}
inline bool same(const TrajectoryPart& a, const TrajectoryPart& b) {
  return a.robot == b.robot && a.order == b.order && a.trajectory == b.trajectory && a.size == b.size &&
         a.begin == b.begin && a.count == b.count &&
         std::memcmp(a.numbers.data(), b.numbers.data(), sizeof a.numbers) == 0;
}
inline bool same(const TrajectoryReport& a, const TrajectoryReport& b) {
  return a.robot == b.robot && a.trajectory == b.trajectory && a.state == b.state && a.text == b.text &&
         a.tick == b.tick;
}
inline bool same(const Counters& a, const Counters& b) {
  static_assert(sizeof(Counters) == 17 * 8, "no padding to compare");
  return std::memcmp(&a, &b, sizeof a) == 0;
}
inline bool same(const ProcessStatus& a, const ProcessStatus& b) {
  return a.process == b.process && a.role == b.role && a.state == b.state && a.boot == b.boot && a.pid == b.pid &&
         a.beat == b.beat && a.tick == b.tick && a.instruction == b.instruction && a.activity == b.activity &&
         a.step == b.step && same(a.error, b.error) && same(a.counters, b.counters);
}

}  // namespace mrroc::links
