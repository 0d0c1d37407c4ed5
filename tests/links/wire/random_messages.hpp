#pragma once

#include <rapidcheck.h>

#include "links/wire/operator_messages.hpp"
#include "links/wire/process_status.hpp"
#include "links/wire/task_messages.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/sensor_link.hpp"

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
struct Arbitrary<mrroc::Load> {
  static Gen<mrroc::Load> arbitrary() {
    return gen::map(gen::arbitrary<mrroc::Twist>(), [](const mrroc::Twist& any) {
      return mrroc::Load{any[0], any.tail<3>()};
    });
  }
};

template <>
struct Arbitrary<mrroc::CommonStop> {
  static Gen<mrroc::CommonStop> arbitrary() {
    using T = mrroc::CommonStop;
    return gen::build<T>(gen::set(&T::ticks), gen::set(&T::rate), gen::set(&T::group));
  }
};

template <>
struct Arbitrary<mrroc::RobotCommand> {
  static Gen<mrroc::RobotCommand> arbitrary() {
    using T = mrroc::RobotCommand;
    return gen::build<T>(
        gen::set(&T::kind, any_enum(mrroc::CommandKind::end)), gen::set(&T::relative), gen::set(&T::motion_steps),
        gen::set(&T::reply_step), gen::set(&T::start_tick), gen::set(&T::joints), gen::set(&T::joint_velocity),
        gen::set(&T::joint_acceleration), gen::set(&T::pose), gen::set(&T::twist), gen::set(&T::twist_acceleration),
        gen::set(&T::choice), gen::set(&T::stop), gen::set(&T::load), gen::set(&T::with_outputs), gen::set(&T::outputs),
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
                         gen::set(&T::coordination, any_enum(mrroc::Coordination::left)), gen::set(&T::macrostep_start),
                         gen::set(&T::model), gen::set(&T::tool), gen::set(&T::wrench), gen::set(&T::lost),
                         gen::set(&T::inputs), gen::set(&T::outputs), gen::set(&T::regulators));
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
struct Arbitrary<mrroc::SensorRequest> {
  static Gen<mrroc::SensorRequest> arbitrary() {
    using T = mrroc::SensorRequest;
    return gen::build<T>(gen::set(&T::kind, any_enum(mrroc::SensorRequestKind::configure)), gen::set(&T::measure_at),
                         gen::set(&T::configuration));
  }
};

template <>
struct Arbitrary<mrroc::SensorReading> {
  static Gen<mrroc::SensorReading> arbitrary() {
    using T = mrroc::SensorReading;
    return gen::build<T>(gen::set(&T::sequence), gen::set(&T::tick), gen::set(&T::configuration),
                         gen::set(&T::channel_count, gen::inRange<std::uint32_t>(0, mrroc::kMaxChannels + 1)),
                         gen::set(&T::values), gen::set(&T::error));
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
struct Arbitrary<mrroc::TrajectoryPart> {
  static Gen<mrroc::TrajectoryPart> arbitrary() {
    using T = mrroc::TrajectoryPart;
    return gen::build<T>(gen::set(&T::robot), gen::set(&T::order, any_enum(mrroc::TrajectoryOrder::cancel)),
                         gen::set(&T::trajectory), gen::set(&T::size), gen::set(&T::begin),
                         gen::set(&T::count, gen::inRange<std::uint16_t>(0, T::kNumbers + 1)), gen::set(&T::numbers));
  }
};

template <>
struct Arbitrary<mrroc::TrajectoryReport> {
  static Gen<mrroc::TrajectoryReport> arbitrary() {
    using T = mrroc::TrajectoryReport;
    return gen::build<T>(gen::set(&T::robot), gen::set(&T::trajectory),
                         gen::set(&T::state, any_enum(mrroc::TrajectoryState::taken_back)), gen::set(&T::text),
                         gen::set(&T::tick));
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
