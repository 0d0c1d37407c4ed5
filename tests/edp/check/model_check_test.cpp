#include "edp/check/model_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "config/message_of.hpp"
#include "config/robot_parameters_file.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::edp::model_check_test {
namespace {

/// motor = gear sin(joint): its dead centres are at plus and minus a right angle. `Fault` makes it another
/// transmission.
class SineModel final : public RobotModel {
 public:
  enum class Fault { none, stuck, other_way_back, turned_round };

  SineModel(std::string name, RobotParameters parameters, double gear, Fault fault = Fault::none)
      : name_(std::move(name)), parameters_(std::move(parameters)), gear_(gear), fault_(fault) {}

  std::string_view name() const noexcept override { return name_; }
  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    const double sine = motors[0] / gear_;
    if (!(std::abs(sine) < 1)) return ErrorCode::motor_limit;
    joints = JointVector::Constant(1, std::asin(sine) * (fault_ == Fault::other_way_back ? 1.001 : 1));
    return ErrorCode::none;
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    motors = JointVector::Constant(1, gear_ * std::sin(joints[0]));
    return ErrorCode::none;
  }
  JointMatrix transmission(const JointVector& joints) const noexcept override {
    const double ratio = gear_ * std::cos(joints[0]);
    if (fault_ == Fault::stuck) return JointMatrix::Zero(1, 1);
    return JointMatrix::Constant(1, 1, fault_ == Fault::turned_round && joints[0] > 0.5 ? -ratio : ratio);
  }
  Pose flange(const JointVector&) const noexcept override { return Pose::Identity(); }
  ErrorCode inverse(const Pose&, const JointVector&, JointVector&) const noexcept override {
    return ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector&, const Eigen::Vector3d&) const noexcept override { return Jacobian::Zero(6, 1); }

 private:
  std::string name_;
  RobotParameters parameters_;
  double gear_;
  Fault fault_;
};

struct Numbers {
  double home = 0, position_min = -1, position_max = 1, motor_min = -9, motor_max = 9;
};

/// A file of one axis with these numbers; `home` is in line 2, the axis begins in line 3.
std::string file_of(const Numbers& numbers) {
  const auto line = [](const char* key, double value) {
    return std::string(key) + " = " + (std::isinf(value) ? (value < 0 ? "-inf" : "inf") : std::to_string(value)) + "\n";
  };
  return "type = \"swing\"\nhome = [" + std::to_string(numbers.home) + "]\n[[axes]]\nname = \"swing\"\n" +
         line("position_min", numbers.position_min) + line("position_max", numbers.position_max) +
         line("motor_min", numbers.motor_min) + line("motor_max", numbers.motor_max) +
         "velocity_max = 1.0\nacceleration_max = 1.0\njerk_max = 25.0\nmotor_synchro = 0.0\ncurrent_max = 1.0\n"
         "following_error_max = 1.0\nregulator_a = 0.5\nregulator_b0 = 1.5\nregulator_b1 = 1.4\nregulator_eps = 0.01\n"
         "regulator_current_gain = 0.2\ntorque_constant = 0.1\nrotor_inertia = 0.001\nviscous_friction = 0.01\n";
}

/// The error in a robot of these numbers and a gear of 10; a second model has `other_gear`.
std::string mistake(const Numbers& numbers, SineModel::Fault fault = SineModel::Fault::none, double other_gear = 10) {
  const task_test::ScratchFolder scratch;
  const auto table = config::Table::load(scratch.write("swing.toml", file_of(numbers)));
  const auto parameters = config::read_robot_parameters(table);
  const RobotModels models{std::make_shared<SineModel>("nominal", parameters, 10, fault),
                           std::make_shared<SineModel>("other", parameters, other_gear)};
  return config::message_of(scratch.path(), [&] { check_models(models, table); });
}

TEST(ModelCheck, AcceptsConsistentNumbers) {
  EXPECT_EQ(mistake({}), "");
  EXPECT_EQ(mistake({.home = -0.9}), "");
  EXPECT_EQ(mistake({.position_min = -1.1, .position_max = 1.1, .motor_min = -9.9, .motor_max = 9.9}), "");
}

TEST(ModelCheck, RefusesHomeBeyondAMotorLimit) {
  const std::string message = mistake({.home = 0.5, .motor_max = 4});
  EXPECT_EQ(message.find("swing.toml:2: home: the motor of axis 'swing' is at 4.79"), 0U) << message;
  EXPECT_NE(message.find("rad there, expected a number from -9 to 4"), std::string::npos) << message;
}

TEST(ModelCheck, RefusesAMotorLimitBeyondTheTransmission) {
  EXPECT_EQ(mistake({.motor_max = 12}).find("swing.toml:8: axes[0].motor_max: 12: no joint position belongs to the "),
            0U);
  EXPECT_EQ(mistake({.motor_min = -12}).find("swing.toml:7: axes[0].motor_min: -12: no joint position belongs to the "),
            0U);
  EXPECT_EQ(mistake({.motor_max = HUGE_VAL}).find("swing.toml:8: axes[0].motor_max: "), 0U) << "one turn is too much";
}

TEST(ModelCheck, RefusesADeadCentreWithinTheJointLimits) {
  const std::string message = mistake({.position_max = 2.5});
  EXPECT_EQ(message.find("swing.toml:3: axes[0]: the transmission of model 'nominal' turns back within the limits: -"),
            0U)
      << message;
  EXPECT_NE(message.find("at joints ("), std::string::npos) << message;
  EXPECT_NE(message.find("expected the sign of 10, as at home"), std::string::npos) << message;
}

TEST(ModelCheck, RefusesATransmissionThatIsNotInvertibleOrChangesSign) {
  EXPECT_EQ(mistake({}, SineModel::Fault::stuck),
            "swing.toml:2: home: the transmission of model 'nominal' cannot be inverted there, expected motors that "
            "move every joint");
  EXPECT_EQ(mistake({}, SineModel::Fault::turned_round).find("swing.toml:3: axes[0]: the transmission"), 0U);
}

TEST(ModelCheck, RefusesAModelThatIsNotItsOwnInverse) {
  const std::string message = mistake({}, SineModel::Fault::other_way_back);
  EXPECT_EQ(message.find("swing.toml:7: axes[0].motor_min: -9: the joints give other motor positions back at "), 0U)
      << message;
}

TEST(ModelCheck, RefusesAJointLimitBeyondTheMotors) {
  EXPECT_EQ(mistake({.motor_max = 8}),
            "swing.toml:6: axes[0].position_max: 1 is out of the motors' reach, expected a position that some posture "
            "has within motor_min and motor_max");
  EXPECT_EQ(mistake({.motor_min = -8}).find("swing.toml:5: axes[0].position_min: -1 is out of the motors' reach"), 0U);
}

TEST(ModelCheck, ChecksEveryModel) {
  EXPECT_EQ(mistake({}, SineModel::Fault::none, 9.5), "");
  const std::string limit = mistake({}, SineModel::Fault::none, 8.5);
  EXPECT_EQ(limit.find("swing.toml:7: axes[0].motor_min: -9: no joint position belongs to the motor at -8."), 0U)
      << limit;
  EXPECT_NE(limit.find("of model 'other'"), std::string::npos) << limit;
  EXPECT_EQ(mistake({.home = 0.9}, SineModel::Fault::none, 7).find("swing.toml:2: home: no joints of model 'other'"),
            0U);
}

}  // namespace
}  // namespace mrroc::edp::model_check_test
