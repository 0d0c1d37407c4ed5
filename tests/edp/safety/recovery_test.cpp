// Recovery from a fault, with every driver: the robot stops and stays stopped, recovers at its measured position, and
// its first command is planned from there.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <tuple>

#include "edp/plants.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::edp::recovery_test {
namespace {

enum class Driver { loopback, mujoco };
enum class Cause { reported_by_the_drives, held_up };

class Recovery : public testing::TestWithParam<std::tuple<Driver, Cause>> {
 protected:
  Recovery() {
    if (std::get<Driver>(GetParam()) == Driver::loopback)
      plant = std::make_unique<LoopbackPlant>(*model);
    else
      plant = std::make_unique<MujocoPlant>(*model, 0.7);
    servo.emplace(models, plant->hardware(), kPeriod, *hand_over);
    effector.emplace(models, kPeriod, *hand_over);
    effector->enable(true);
    tick();
  }

  void tick() {
    plant->advance(now);
    servo->tick(now++);
    Reply reply;
    while (effector->poll(reply)) replies.push_back(reply);
    check_set_point();
  }
  void run(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) tick();
  }
  const Snapshot& seen() const { return servo->snapshot(); }

  /// While the drives are on, every set-point follows from the one before within the limits of the axes.
  void check_set_point() {
    const DesiredState& desired = seen().desired;
    if (servo->drives_on() && was_on) {
      for (Eigen::Index i = 0; i < desired.position.size(); ++i) {
        const AxisParameters& axis = model->parameters().axes[static_cast<std::size_t>(i)];
        ASSERT_LE(std::abs(desired.velocity[i]), axis.velocity_max * (1 + 1e-6)) << "axis " << i << " tick " << now;
        ASSERT_LE(std::abs(desired.acceleration[i]), axis.acceleration_max * (1 + 1e-6)) << i << " tick " << now;
        ASSERT_LE(std::abs(desired.acceleration[i] - previous.acceleration[i]), axis.jerk_max * kPeriod * (1 + 1e-6))
            << i << " tick " << now;
        // the error of the trapezoidal rule under the jerk limit
        const double way = 0.5 * kPeriod * (desired.velocity[i] + previous.velocity[i]);
        ASSERT_LE(std::abs(desired.position[i] - previous.position[i] - way),
                  axis.jerk_max * kPeriod * kPeriod * kPeriod / 12 + 1e-12)
            << i << " tick " << now;
      }
      ++checked;
    }
    was_on = servo->drives_on();
    previous = desired;
  }

  bool send(const RobotCommand& command) { return effector->accept(command, ++number, answer); }
  JointVector near_home(double lower_arm, double upper_arm) const {
    JointVector joints = model->parameters().home;
    joints[0] += 0.1;
    joints[1] += lower_arm;
    joints[2] += upper_arm;
    return joints;
  }
  void disturb(bool on) {
    if (std::get<Cause>(GetParam()) == Cause::reported_by_the_drives)
      plant->fail(on);
    else
      plant->push(on);
  }
  /// The first symptom of an external force on the robot depends on the plant.
  ErrorCode expected_fault() {
    if (std::get<Cause>(GetParam()) == Cause::held_up) {
      const ErrorCode seen_as = seen().fault.code;
      const bool fits = seen_as == ErrorCode::axis_stuck || seen_as == ErrorCode::overspeed;
      return fits ? seen_as : ErrorCode::following_error;
    }
    return std::get<Driver>(GetParam()) == Driver::loopback ? ErrorCode::drive_fault : ErrorCode::hardware_silent;
  }

  std::shared_ptr<const RobotModel> model = load_irb6().front();
  std::unique_ptr<Plant> plant;
  std::unique_ptr<ServoChannel> hand_over = std::make_unique<ServoChannel>();
  ModelSet models{*model};
  std::optional<Servo> servo;
  std::optional<Effector> effector;
  Tick now = 0;
  std::uint64_t number = 0;
  Reply answer;
  std::vector<Reply> replies;
  bool was_on = false;
  DesiredState previous;
  int checked = 0;
};

TEST_P(Recovery, TheFirstMotionStartsWhereTheRobotIsMeasuredAndNothingJumps) {
  run(100);
  ASSERT_FALSE(send(joint_command(near_home(0.2, -0.2), 1500, 1500)));
  run(600);
  ASSERT_GT(seen().desired.velocity.norm(), 0.1) << "it is moving";

  // the fault stops the robot, then the drives go off
  disturb(true);
  for (int i = 0; i < 1000 && servo->drives_on(); ++i) tick();
  ASSERT_FALSE(servo->drives_on());
  EXPECT_EQ(seen().fault.code, expected_fault());
  ASSERT_EQ(replies.size(), 1u) << "the motion's";
  EXPECT_EQ(replies[0].state.error.error_class, ErrorClass::hardware);
  EXPECT_EQ(replies[0].state.error.code, expected_fault());
  disturb(false);

  // it is latched: its cause is over, but the robot stays at its position and executes no command
  run(100);
  const JointVector stands = seen().joints;
  ASSERT_TRUE(send(joint_command(near_home(0, 0), 1500, 1500)));
  EXPECT_EQ(answer.state.error.code, expected_fault());
  run(300);
  EXPECT_EQ(seen().fault.code, expected_fault());
  EXPECT_FALSE(servo->drives_on());
  EXPECT_EQ(seen().joints, stands);

  // recovered: the set-point is the measured position, at rest, and the drives get no commands
  replies.clear();
  RobotCommand recover;
  recover.kind = CommandKind::recover;
  ASSERT_FALSE(send(recover));
  while (replies.empty() && now < 10'000) tick();
  ASSERT_EQ(replies.size(), 1u);
  const RobotState& recovered = replies[0].state;
  EXPECT_EQ(recovered.error.error_class, ErrorClass::none) << recovered.error.detail.view();
  EXPECT_TRUE(recovered.enabled);
  EXPECT_EQ(recovered.joints, stands);
  EXPECT_EQ(recovered.desired_joints, stands);
  EXPECT_TRUE(seen().desired.at_rest());
  checked = 0;
  tick();
  EXPECT_LT(seen().current.cwiseAbs().maxCoeff(), 1e-9) << "except for rounding";
  run(299);
  EXPECT_EQ(seen().desired.position, stands);
  EXPECT_LT((seen().joints - stands).cwiseAbs().maxCoeff(), 2e-3)
      << "the deflection while the regulators take up the weight";

  // the first command: from there, within the limits of every tick (check_set_point), to its target
  const JointVector target = near_home(-0.1, 0.1);
  ASSERT_GT((target - stands).norm(), 0.05);
  ASSERT_FALSE(send(joint_command(target, 2500, 2500))) << answer.state.error.detail.view();
  tick();
  EXPECT_LT((seen().desired.position - stands).cwiseAbs().maxCoeff(), 1e-6);
  run(3000);
  EXPECT_EQ(checked, 3301);
  EXPECT_EQ(seen().fault.code, ErrorCode::none);
  EXPECT_EQ(seen().desired.position, target);
  EXPECT_LT((seen().joints - target).cwiseAbs().maxCoeff(), 1e-3);
}

TEST_P(Recovery, WhileTheCauseLastsTheRobotIsStoppedAnew) {
  run(100);
  disturb(true);
  for (int attempt = 0; attempt < 3; ++attempt) {
    for (int i = 0; i < 1000 && (servo->drives_on() || seen().fault.code == ErrorCode::none); ++i) tick();
    ASSERT_EQ(seen().fault.code, expected_fault()) << attempt;
    ASSERT_FALSE(servo->drives_on());
    replies.clear();
    RobotCommand recover;
    recover.kind = CommandKind::recover;
    ASSERT_FALSE(send(recover));
    run(3);
    ASSERT_EQ(replies.size(), 1u);
    // a reported fault keeps the drives off; a force has an effect only when they are on
    const bool reported = std::get<Cause>(GetParam()) == Cause::reported_by_the_drives;
    EXPECT_EQ(replies[0].state.error.code, reported ? expected_fault() : ErrorCode::none) << attempt;
    if (reported) {
      EXPECT_FALSE(servo->drives_on());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryDriver, Recovery,
                         testing::Combine(testing::Values(Driver::loopback, Driver::mujoco),
                                          testing::Values(Cause::reported_by_the_drives, Cause::held_up)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param) == Driver::loopback ? "Loopback" : "Mujoco") +
                                  (std::get<1>(test.param) == Cause::held_up ? "HeldUp" : "Fault");
                         });

}  // namespace
}  // namespace mrroc::edp::recovery_test
