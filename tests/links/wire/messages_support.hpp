#pragma once

#include <rapidcheck.h>

#include <cstring>

#include "links/wire/operator_messages.hpp"
#include "links/wire/process_status.hpp"
#include "links/wire/task_messages.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::links {

// ---- bitwise equality of two messages
// -------------------------------------------------------------------

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
         a.choice == b.choice && a.with_outputs == b.with_outputs && a.outputs == b.outputs &&
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
         a.enabled == b.enabled && a.late_commands == b.late_commands && same(a.error, b.error) &&
         a.macrostep_start == b.macrostep_start && a.model == b.model &&
         same_matrix(a.tool.matrix(), b.tool.matrix()) && same_matrix(a.wrench, b.wrench) && a.lost == b.lost &&
         a.inputs == b.inputs && a.outputs == b.outputs && a.regulators == b.regulators;
}
inline bool same(const SensorRequest& a, const SensorRequest& b) {
  return a.kind == b.kind && a.measure_at == b.measure_at;
}
inline bool same(const SensorReading& a, const SensorReading& b) {
  return a.sequence == b.sequence && a.tick == b.tick && a.channel_count == b.channel_count &&
         std::memcmp(a.values.data(), b.values.data(), sizeof a.values) == 0 && same(a.error, b.error);
}
inline bool same(const Message& a, const Message& b) {
  return a.label == b.label && a.fingerprint == b.fingerprint && a.size == b.size && a.content == b.content;
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

// ---- arbitrary messages
// -----------------------------------------------------------------------------------------------------

namespace rc {

template <class Enum>
Gen<Enum> any_enum(Enum last) {
  return gen::map(gen::inRange(0, static_cast<int>(last) + 1), [](int value) { return static_cast<Enum>(value); });
}

template <std::size_t Capacity>
struct Arbitrary<mrroc::FixedText<Capacity>> {
  static Gen<mrroc::FixedText<Capacity>> arbitrary() {
    return gen::map(gen::arbitrary<std::string>(),
                    [](const std::string& text) { return mrroc::FixedText<Capacity>{text.c_str()}; });
  }
};

template <>
struct Arbitrary<mrroc::JointVector> {
  static Gen<mrroc::JointVector> arbitrary() {
    return gen::map(
        gen::resize(mrroc::kMaxJoints, gen::arbitrary<std::vector<double>>()), [](const std::vector<double>& values) {
          const auto size = std::min<std::size_t>(values.size(), mrroc::kMaxJoints);
          return mrroc::JointVector{Eigen::Map<const Eigen::VectorXd>{values.data(), static_cast<Eigen::Index>(size)}};
        });
  }
};

template <>
struct Arbitrary<mrroc::Pose> {
  static Gen<mrroc::Pose> arbitrary() {
    return gen::map(gen::container<std::vector<double>>(12, gen::arbitrary<double>()),
                    [](const std::vector<double>& values) {
                      mrroc::Pose pose = mrroc::Pose::Identity();
                      pose.matrix().topRows<3>() = Eigen::Map<const Eigen::Matrix<double, 3, 4>>{values.data()};
                      return pose;
                    });
  }
};

template <>
struct Arbitrary<mrroc::Twist> {
  static Gen<mrroc::Twist> arbitrary() {
    return gen::map(
        gen::container<std::vector<double>>(6, gen::arbitrary<double>()),
        [](const std::vector<double>& values) { return mrroc::Twist{Eigen::Map<const mrroc::Twist>{values.data()}}; });
  }
};

template <>
struct Arbitrary<mrroc::ErrorReport> {
  static Gen<mrroc::ErrorReport> arbitrary() {
    using mrroc::ErrorCode;
    return gen::build<mrroc::ErrorReport>(
        gen::set(&mrroc::ErrorReport::error_class, any_enum(mrroc::ErrorClass::system)),
        gen::set(&mrroc::ErrorReport::code, gen::element(ErrorCode::none, ErrorCode::singular, ErrorCode::not_enabled,
                                                         ErrorCode::drive_fault, ErrorCode::simulator)),
        gen::set(&mrroc::ErrorReport::detail));
  }
};

template <>
struct Arbitrary<mrroc::ControllerIo> {
  static Gen<mrroc::ControllerIo> arbitrary() {
    using T = mrroc::ControllerIo;
    return gen::build<T>(gen::set(&T::digital), gen::set(&T::analog));
  }
};

template <>
struct Arbitrary<mrroc::ForceLaw> {
  static Gen<mrroc::ForceLaw> arbitrary() {
    using T = mrroc::ForceLaw;
    return gen::build<T>(gen::set(&T::behaviour, gen::container<std::array<mrroc::AxisBehaviour, 6>>(
                                                     any_enum(mrroc::AxisBehaviour::contact))),
                         gen::set(&T::wrench), gen::set(&T::inertia), gen::set(&T::admittance));
  }
};

template <>
struct Arbitrary<mrroc::RobotCommand> {
  static Gen<mrroc::RobotCommand> arbitrary() {
    using T = mrroc::RobotCommand;
    return gen::build<T>(gen::set(&T::kind, any_enum(mrroc::CommandKind::set_outputs)), gen::set(&T::relative),
                         gen::set(&T::motion_steps), gen::set(&T::reply_step), gen::set(&T::start_tick),
                         gen::set(&T::joints), gen::set(&T::joint_velocity), gen::set(&T::joint_acceleration),
                         gen::set(&T::pose), gen::set(&T::twist), gen::set(&T::twist_acceleration),
                         gen::set(&T::choice), gen::set(&T::with_outputs), gen::set(&T::outputs),
                         gen::set(&T::interpolation, any_enum(mrroc::Interpolation::task)), gen::set(&T::force));
  }
};

template <>
struct Arbitrary<mrroc::RobotState> {
  static Gen<mrroc::RobotState> arbitrary() {
    using T = mrroc::RobotState;
    return gen::build<T>(gen::set(&T::tick), gen::set(&T::joints), gen::set(&T::joint_velocity), gen::set(&T::motors),
                         gen::set(&T::current), gen::set(&T::pose), gen::set(&T::desired_tick),
                         gen::set(&T::desired_joints), gen::set(&T::desired_velocity),
                         gen::set(&T::desired_acceleration), gen::set(&T::desired_pose), gen::set(&T::synchronised),
                         gen::set(&T::enabled), gen::set(&T::late_commands), gen::set(&T::error),
                         gen::set(&T::macrostep_start), gen::set(&T::model), gen::set(&T::tool), gen::set(&T::wrench),
                         gen::set(&T::lost), gen::set(&T::inputs), gen::set(&T::outputs), gen::set(&T::regulators));
  }
};

template <>
struct Arbitrary<mrroc::SensorRequest> {
  static Gen<mrroc::SensorRequest> arbitrary() {
    using T = mrroc::SensorRequest;
    return gen::build<T>(gen::set(&T::kind, any_enum(mrroc::SensorRequestKind::bias)), gen::set(&T::measure_at));
  }
};

template <>
struct Arbitrary<mrroc::SensorReading> {
  static Gen<mrroc::SensorReading> arbitrary() {
    using T = mrroc::SensorReading;
    return gen::build<T>(gen::set(&T::sequence), gen::set(&T::tick),
                         gen::set(&T::channel_count, gen::inRange<std::uint32_t>(0, mrroc::kMaxChannels + 1)),
                         gen::set(&T::values), gen::set(&T::error));
  }
};

template <>
struct Arbitrary<mrroc::Message> {
  static Gen<mrroc::Message> arbitrary() {
    using T = mrroc::Message;
    return gen::build<T>(gen::set(&T::label), gen::set(&T::fingerprint),
                         gen::set(&T::size, gen::inRange<std::uint16_t>(0, T::kCapacity + 1)), gen::set(&T::content));
  }
};

template <>
struct Arbitrary<mrroc::links::TaskCommand> {
  static Gen<mrroc::links::TaskCommand> arbitrary() {
    using T = mrroc::links::TaskCommand;
    return gen::build<T>(gen::set(&T::kind, any_enum(mrroc::links::TaskCommandKind::speed)), gen::set(&T::parcel),
                         gen::set(&T::speed));
  }
};

template <>
struct Arbitrary<mrroc::links::TaskStatus> {
  static Gen<mrroc::links::TaskStatus> arbitrary() {
    using T = mrroc::links::TaskStatus;
    return gen::build<T>(gen::set(&T::state, any_enum(mrroc::links::TaskState::stopped)), gen::set(&T::error),
                         gen::set(&T::process), gen::set(&T::device), gen::set(&T::step), gen::set(&T::error_tick),
                         gen::set(&T::tick), gen::set(&T::parcel));
  }
};

template <>
struct Arbitrary<mrroc::links::OperatorQuestion> {
  static Gen<mrroc::links::OperatorQuestion> arbitrary() {
    using T = mrroc::links::OperatorQuestion;
    return gen::build<T>(gen::set(&T::text), gen::set(&T::kind, any_enum(mrroc::links::QuestionKind::choice)),
                         gen::set(&T::minimum), gen::set(&T::maximum),
                         gen::set(&T::choice_count, gen::inRange<std::uint8_t>(0, T::kChoices + 1)),
                         gen::set(&T::choices), gen::set(&T::tick));
  }
};

template <>
struct Arbitrary<mrroc::links::OperatorAnswer> {
  static Gen<mrroc::links::OperatorAnswer> arbitrary() {
    using T = mrroc::links::OperatorAnswer;
    return gen::build<T>(gen::set(&T::question), gen::set(&T::value));
  }
};

template <>
struct Arbitrary<mrroc::links::Counters> {
  static Gen<mrroc::links::Counters> arbitrary() {
    using T = mrroc::links::Counters;
    return gen::build<T>(gen::set(&T::ticks), gen::set(&T::missed_ticks), gen::set(&T::late_commands),
                         gen::set(&T::stale_replies), gen::set(&T::common_steps), gen::set(&T::skew_ticks),
                         gen::set(&T::packages), gen::set(&T::packages_lost), gen::set(&T::packages_doubled),
                         gen::set(&T::packages_late), gen::set(&T::packages_bunched), gen::set(&T::wakeup_p50_us),
                         gen::set(&T::wakeup_p99_us), gen::set(&T::wakeup_max_us), gen::set(&T::execution_p50_us),
                         gen::set(&T::execution_p99_us), gen::set(&T::execution_max_us));
  }
};

template <>
struct Arbitrary<mrroc::links::ProcessStatus> {
  static Gen<mrroc::links::ProcessStatus> arbitrary() {
    using T = mrroc::links::ProcessStatus;
    return gen::build<T>(gen::set(&T::process), gen::set(&T::role, any_enum(mrroc::links::ProcessRole::sim)),
                         gen::set(&T::state, any_enum(mrroc::links::ProcessState::failed)), gen::set(&T::boot),
                         gen::set(&T::pid), gen::set(&T::beat), gen::set(&T::tick), gen::set(&T::instruction),
                         gen::set(&T::activity), gen::set(&T::step), gen::set(&T::error), gen::set(&T::counters));
  }
};

}  // namespace rc
