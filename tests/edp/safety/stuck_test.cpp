// Detection of a stuck axis, for every robot: a free shaft must always move.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "edp/command/effector.hpp"
#include "edp/every_robot.hpp"
#include "edp/servo/servo.hpp"
#include "repetitions.hpp"

namespace mrroc::edp::stuck_test {
namespace {

constexpr double kTime = 0.002;

double increment(const AxisParameters& axis) { return 2 * std::numbers::pi / axis.encoder_increments; }

/// Drives whose shafts can be held.
class HeldDrives : public Hardware {
 public:
  explicit HeldDrives(const RobotModel& model) : model_(model) {
    model.joints_to_motors(model.parameters().home, shafts_);
    target_ = shafts_;
    current = JointVector::Zero(shafts_.size());
  }
  void open() override {}
  void enable(bool on) noexcept override { on_ = on; }
  void set_origin(const JointVector&) noexcept override {}
  void set_points(const JointVector& position, const JointVector&) noexcept override { target_ = position; }

  const JointVector& set_point() const { return target_; }

  JointVector current;  ///< measured, A
  int held = -1;        ///< this shaft stands still regardless of its drive

 protected:
  void report(Tick tick, HardwareInput& input) const {
    input.time = static_cast<double>(tick);
    input.motors = shafts_;
    input.current = current;
    input.synchronised = true;
    input.fault = ErrorCode::none;
  }
  const AxisParameters& axis(Eigen::Index i) const { return model_.parameters().axes[static_cast<std::size_t>(i)]; }

  const RobotModel& model_;
  JointVector shafts_, target_;
  bool on_ = false;
};

/// Drives that regulate on their own: a shaft is at its set-point, to a whole number of increments less a residual.
class RegulatingDrives final : public HeldDrives {
 public:
  using HeldDrives::HeldDrives;
  void read(Tick tick, HardwareInput& input) noexcept override {
    if (wander) wander(tick, current);
    report(tick, input);
  }
  void write(Tick, const JointVector&) noexcept override {
    if (!on_) return;
    for (Eigen::Index i = 0; i < shafts_.size(); ++i)
      if (i != held) shafts_[i] = (std::round(target_[i] / increment(axis(i))) - residual) * increment(axis(i));
  }
  double residual = 0;                             ///< increments
  std::function<void(Tick, JointVector&)> wander;  ///< what they measure
};

/// Drives that follow the current. Model: rotor, viscous friction, a load, and a static friction that holds the shaft
/// until the remaining torque is greater, and slows it down afterwards.
class FrictionDrives final : public HeldDrives {
 public:
  explicit FrictionDrives(const RobotModel& model)
      : HeldDrives(model),
        load(JointVector::Zero(shafts_.size())),
        friction(JointVector::Zero(shafts_.size())),
        true_(shafts_),
        speed_(JointVector::Zero(shafts_.size())) {}
  bool follows_current() const noexcept override { return true; }
  void read(Tick tick, HardwareInput& input) noexcept override {
    for (Eigen::Index i = 0; i < shafts_.size(); ++i) {
      if (i == held) speed_[i] = 0;
      for (int k = 0; on_ && i != held && k < kSubsteps; ++k) turn(i);
      shafts_[i] = std::floor(true_[i] / increment(axis(i)) + 0.5) * increment(axis(i));
    }
    report(tick, input);
  }
  void write(Tick, const JointVector& given) noexcept override { current = on_ ? given : 0 * given; }
  JointVector load, friction;  ///< A

 private:
  static constexpr int kSubsteps = 20;
  void turn(Eigen::Index i) {
    const AxisParameters& a = axis(i);
    const double time = kTime / kSubsteps, driving = current[i] - load[i];
    if (speed_[i] == 0 && std::abs(driving) <= friction[i]) return;
    const double sense = speed_[i] != 0 ? std::copysign(1, speed_[i]) : std::copysign(1, driving);
    const double torque = a.torque_constant * (driving - sense * friction[i]);
    double speed = (speed_[i] + time * torque / a.rotor_inertia) / (1 + time * a.viscous_friction / a.rotor_inertia);
    if (speed * sense < 0) speed = 0;  // it stops, and friction holds it
    true_[i] += time * speed;
    speed_[i] = speed;
  }
  JointVector true_, speed_;
};

template <class Drives>
class Driven {
 public:
  explicit Driven(const RobotModels& models) : set_(models), drives(*models.front()) {
    servo_->use_emergency_stop(stop_);
    effector_->enable(true);
    run(5);
  }
  void run(Tick ticks) {
    Reply reply;
    for (Tick i = 0; i < ticks && fault().code == ErrorCode::none; ++i) {
      servo_->tick(now_++);
      while (effector_->poll(reply)) {
      }
    }
  }
  /// A motion with `part` of every joint's speed limit, for `steps` ticks; false: refused.
  bool move(double part, std::uint16_t steps) {
    RobotCommand command;
    command.kind = CommandKind::joint;
    command.relative = true;
    command.joints.resize(set_.at(0).joint_count());
    for (Eigen::Index i = 0; i < command.joints.size(); ++i)
      command.joints[i] = part * set_.parameters().axes[static_cast<std::size_t>(i)].velocity_max * steps * kTime / 2;
    command.motion_steps = command.reply_step = steps;
    Reply reply;
    if (!effector_->accept(command, ++number_, reply)) return true;
    ADD_FAILURE() << reply.state.error.detail.view();
    return false;
  }
  const Fault& fault() const { return servo_->snapshot().fault; }
  const Snapshot& seen() const { return servo_->snapshot(); }
  std::string text() const {
    return std::string(describe(fault().code)) + ", axis " + std::to_string(fault().axis + 1) + ", after " +
           std::to_string(static_cast<double>(now_) * kTime) + " s";
  }

 private:
  ModelSet set_;

 public:
  Drives drives;

 private:
  std::unique_ptr<ServoChannel> channel_ = std::make_unique<ServoChannel>();
  clock::EmergencyStop stop_;
  std::unique_ptr<Servo> servo_ = std::make_unique<Servo>(set_, drives, kTime, *channel_);
  std::unique_ptr<Effector> effector_ = std::make_unique<Effector>(set_, kTime, *channel_);
  Tick now_ = 0;
  std::uint64_t number_ = 0;
};

constexpr Tick kMinute = 30'000, kMotion = 200;

class AtRest : public testing::TestWithParam<KnownRobot> {
 protected:
  RobotModels models = GetParam().load(GetParam().file("toml"));
  const RobotParameters& parameters = models.front()->parameters();
};

TEST_P(AtRest, RegulatingDrivesMayKeepAResidualError) {
  for (const double residual : {0.0, 0.4, 1.0, -2.0, 3.0}) {
    Driven<RegulatingDrives> robot(models);
    ASSERT_TRUE(robot.move(0.02, kMotion));
    robot.run(kMotion / 2);
    robot.drives.residual = residual;
    robot.run(kMotion + kMinute);
    EXPECT_EQ(robot.fault().code, ErrorCode::none) << residual << ": " << robot.text();
  }
}

/// Holding currents of a drive: from the previous motion, a new load, friction, a sensor's noise.
TEST_P(AtRest, RegulatingDrivesMayHoldWithAnyCurrent) {
  std::mt19937 random(5);
  const auto any = [&random](double most) { return std::uniform_real_distribution<double>(-most, most)(random); };
  const std::vector<std::function<double(double, double)>> currents{
      [](double, double) { return 0.0; }, [](double time, double most) { return time < 0.5 ? 0.8 * most : 0.3 * most; },
      [](double time, double most) { return std::min(0.9, 0.05 * time) * most; },
      [](double time, double most) { return 0.5 * most * std::sin(time); },
      [&any](double, double most) { return any(0.3 * most); }};
  for (std::size_t kind = 0; kind < currents.size(); ++kind) {
    Driven<RegulatingDrives> robot(models);
    robot.drives.residual = 1;
    robot.drives.wander = [&](Tick tick, JointVector& current) {
      for (Eigen::Index i = 0; i < current.size(); ++i)
        current[i] =
            currents[kind](static_cast<double>(tick) * kTime, parameters.axes[static_cast<std::size_t>(i)].current_max);
    };
    ASSERT_TRUE(robot.move(0.02, kMotion));
    robot.run(kMotion + kMinute / 2);
    EXPECT_EQ(robot.fault().code, ErrorCode::none) << "current " << kind << ": " << robot.text();
  }
}

/// The change of current by which a free drive would reach the permitted speed, A (MotionWatch).
double change_that_moves(const RobotModel& model, Eigen::Index i) {
  const JointMatrix ratio = model.transmission(model.parameters().home).inverse();
  const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
  double speed = INFINITY;
  for (Eigen::Index j = 0; j < ratio.rows(); ++j)
    if (ratio(j, i) != 0)
      speed = std::min(speed, MotionWatch::kPushed * model.parameters().axes[static_cast<std::size_t>(j)].velocity_max /
                                  std::abs(ratio(j, i)));
  return speed * axis.viscous_friction / axis.torque_constant + axis.stuck_current;
}

/// The servo's regulator occasionally turns a shaft that friction holds by an increment; its current moves from one
/// side of the friction to the other meanwhile.
TEST_P(AtRest, ServosRegulatorMayHoldALoadAgainstFriction) {
  std::mt19937 random(6);
  for (int i = 0; i < 3; ++i) {
    Driven<FrictionDrives> robot(models);
    for (Eigen::Index k = 0; k < robot.drives.load.size(); ++k) {
      const double most =
          std::min(parameters.axes[static_cast<std::size_t>(k)].current_max, change_that_moves(*models.front(), k));
      robot.drives.friction[k] = std::uniform_real_distribution<double>(0, 0.4)(random) * most;
      robot.drives.load[k] = std::uniform_real_distribution<double>(-0.4, 0.4)(random) * most;
    }
    robot.run(kMotion);  // the regulator takes the load up
    ASSERT_TRUE(robot.move(0.0005 + 0.0003 * i, kMotion));
    robot.run(kMotion + kMinute);
    EXPECT_EQ(robot.fault().code, ErrorCode::none) << i << ": " << robot.text();
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, AtRest, testing::ValuesIn(every_robot()),
                         [](const auto& test) { return test.param.stem; });

TEST(AtRest, DurationHasNoEffect) {
  const RobotModels models = every_robot()[2].load(every_robot()[2].file("toml"));
  Driven<RegulatingDrives> robot(models);
  ASSERT_TRUE(robot.move(0.05, kMotion));
  robot.drives.residual = 1;
  robot.run(test::repetitions(60u) * kMinute);
  EXPECT_EQ(robot.fault().code, ErrorCode::none) << robot.text();
}

class Held : public AtRest {
 protected:
  /// Its shaft is held in a motion, and this is detected before its set-point has moved by more than stuck_max.
  template <class Drives>
  void expect_found(int axis, double part, bool measured) {
    SCOPED_TRACE(testing::Message() << "axis " << axis << " at " << part << " of its speed");
    Driven<Drives> robot(models);
    constexpr std::uint16_t kLong = 1000;
    ASSERT_TRUE(robot.move(part, kLong));
    robot.run(kLong / 4);
    ASSERT_EQ(robot.fault().code, ErrorCode::none) << robot.text();
    robot.drives.held = axis;
    robot.run(1);
    const double there = robot.seen().motors[axis];
    if (measured) robot.drives.current[axis] = parameters.axes[static_cast<std::size_t>(axis)].current_max;
    const JointVector begin = robot.drives.set_point();
    JointVector end = begin;
    for (int i = 0; i < kLong && robot.fault().code == ErrorCode::none; ++i) {
      end = robot.drives.set_point();
      robot.run(1);
    }
    EXPECT_EQ(robot.fault().code, ErrorCode::axis_stuck) << robot.text();
    EXPECT_EQ(robot.fault().axis, axis);
    EXPECT_EQ(robot.seen().motors[axis], there);
    const AxisParameters& a = parameters.axes[static_cast<std::size_t>(axis)];
    EXPECT_LE(std::abs(end[axis] - begin[axis]), a.stuck_max + increment(a));
  }
};

TEST_P(Held, ShaftIsDetectedWithEveryDrive) {
  for (int axis = 0; axis < static_cast<int>(parameters.axes.size()); ++axis) {
    const AxisParameters& a = parameters.axes[static_cast<std::size_t>(axis)];
    if (a.stuck_max > a.following_error_max / 2) continue;  // a gripper is held on purpose
    for (const double part : {0.05, 0.2}) {
      expect_found<RegulatingDrives>(axis, part, false);
      expect_found<RegulatingDrives>(axis, part, true);
      expect_found<FrictionDrives>(axis, part, false);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Held, testing::ValuesIn(every_robot()),
                         [](const auto& test) { return test.param.stem; });

}  // namespace
}  // namespace mrroc::edp::stuck_test
