#include "edp/check/model_check.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "config/text/message_text.hpp"
#include "edp/check/postures.hpp"

namespace mrroc::edp {
namespace {

using config::number_text;

constexpr std::uint64_t kModelSeed = 1;
constexpr int kModelPostures = 200;
constexpr int kSteps = 32;              // of a motor over its range
constexpr int kTriesForALimit = 20000;  // random postures until a joint limit counts as out of reach
constexpr double kReturn = 1e-6;        // of a position converted there and back, relative to it where it is above 1

std::string axis_text(const AxisParameters& axis) { return "axis " + config::in_quotes(axis.name); }

/// Index of the first of `values` that differs from `expected`; -1: all are equal.
Eigen::Index first_change(const JointVector& values, const JointVector& expected) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    // written so that a value that is not a number differs
    if (!(std::abs(values[i] - expected[i]) <= kReturn * std::max(1.0, std::abs(expected[i])))) return i;
  }
  return -1;
}

/// One model of a robot against its file.
class ModelCheck {
 public:
  ModelCheck(const RobotModel& model, const JointVector& home_motors, const config::Table& file)
      : model_(model), axes_(model.parameters().axes), file_(file), tables_(file.tables("axes")), motors_(home_motors) {
    if (model.motors_to_joints(motors_, home_) != ErrorCode::none) {
      file.fail("home", "no joints of model " + name() + " belong to its motor positions " + joints_text(motors_),
                "a posture that every model has");
    }
    ratios_ = model.transmission(home_);
    const Eigen::FullPivLU<JointMatrix> lu(ratios_);
    if (!ratios_.allFinite() || !lu.isInvertible()) {
      file.fail("home", "the transmission of model " + name() + " cannot be inverted there",
                "motors that move every joint");
    }
    determinant_ = lu.determinant();
  }

  void check_motors() const {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const double home = motors_[index(i)];
      // the travel of a motor without a limit: a turn of its joint
      const double turn = 2 * std::numbers::pi * std::abs(ratios_(index(i), index(i)));
      check_way(i, "motor_min", std::isfinite(axes_[i].motor_min) ? axes_[i].motor_min : home - turn);
      check_way(i, "motor_max", std::isfinite(axes_[i].motor_max) ? axes_[i].motor_max : home + turn);
    }
  }

  void check_postures() const {
    for (const JointVector& joints : postures(model_, kModelPostures, kModelSeed)) {
      JointVector motors, back;
      if (model_.joints_to_motors(joints, motors) != ErrorCode::none) continue;  // home of another model
      check_transmission(joints);
      const bool returns = model_.motors_to_joints(motors, back) == ErrorCode::none;
      const Eigen::Index i = returns ? first_change(back, joints) : 0;
      if (i >= 0) {
        const std::string found = returns ? number_text(back[i]) : "nothing";
        tables_[static_cast<std::size_t>(i)].fail(
            "", "the motors of model " + name() + " at joints " + joints_text(joints) + " give " + found + " back",
            "the joint's " + number_text(joints[i]));
      }
    }
  }

  void check_joint_limits() const {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      check_reached(i, "position_min", axes_[i].position_min);
      check_reached(i, "position_max", axes_[i].position_max);
    }
  }

 private:
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
  std::string name() const { return config::in_quotes(model_.name()); }

  /// Motor `i` from home to `end`, the others at home.
  void check_way(std::size_t i, std::string_view key, double end) const {
    for (int step = 1; step <= kSteps; ++step) {
      JointVector motors = motors_, joints, back;
      motors[index(i)] += (end - motors[index(i)]) * step / kSteps;
      const auto fail = [&](const std::string& problem) {
        tables_[i].fail(key, number_text(end) + ": " + problem + " at " + number_text(motors[index(i)]) + " rad",
                        "a motor position that the transmission of model " + name() + " reaches");
      };
      if (model_.motors_to_joints(motors, joints) != ErrorCode::none) fail("no joint position belongs to the motor");
      check_transmission(joints);
      if (model_.joints_to_motors(joints, back) != ErrorCode::none) continue;  // out of reach for another reason
      if (first_change(back, motors) >= 0) fail("the joints give other motor positions back");
    }
  }

  void check_transmission(const JointVector& joints) const {
    const JointMatrix ratios = model_.transmission(joints);
    const Eigen::FullPivLU<JointMatrix> lu(ratios);
    if (ratios.allFinite() && lu.isInvertible() && lu.determinant() * determinant_ > 0) return;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const double here = ratios(index(i), index(i)), at_home = ratios_(index(i), index(i));
      if (here * at_home > 0) continue;
      tables_[i].fail("",
                      "the transmission of model " + name() + " turns back within the limits: " + number_text(here) +
                          " rad of the motor per rad or m at joints " + joints_text(joints),
                      "the sign of " + number_text(at_home) + ", as at home");
    }
    file_.fail("axes", "the transmission of model " + name() + " cannot be inverted at joints " + joints_text(joints),
               "motors that move every joint");
  }

  /// Brings some of the joints to their limits.
  void to_corners(JointVector& joints, std::mt19937_64& random) const {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const int corner = std::uniform_int_distribution<int>(0, 3)(random);
      if (corner == 0 && std::isfinite(axes_[i].position_min)) joints[index(i)] = axes_[i].position_min;
      if (corner == 1 && std::isfinite(axes_[i].position_max)) joints[index(i)] = axes_[i].position_max;
    }
  }

  void check_reached(std::size_t i, std::string_view key, double limit) const {
    if (!std::isfinite(limit)) return;
    std::mt19937_64 random(kModelSeed);
    for (int tries = 0; tries < kTriesForALimit; ++tries) {
      JointVector joints = tries == 0 ? model_.parameters().home : random_joints(model_, random);
      // where motors turn with several joints, a limit may be within reach in a corner only
      if (tries > 0 && tries % 2 == 0) to_corners(joints, random);
      joints[index(i)] = limit;
      if (within_motor_limits(model_, joints)) return;
    }
    tables_[i].fail(key, number_text(limit) + " is out of the motors' reach",
                    "a position that some posture has within motor_min and motor_max");
  }

  const RobotModel& model_;
  const std::vector<AxisParameters>& axes_;
  const config::Table& file_;
  const std::vector<config::Table> tables_;
  JointVector motors_;  ///< at home
  JointVector home_;    ///< this model's joints there
  JointMatrix ratios_;  ///< its transmission there
  double determinant_;  ///< of `ratios_`
};

JointVector check_home(const RobotModel& model, const config::Table& file) {
  const JointVector& home = model.parameters().home;
  JointVector motors;
  if (model.joints_to_motors(home, motors) != ErrorCode::none) {
    file.fail("home", "the transmission does not reach " + joints_text(home), "a posture that it reaches");
  }
  for (std::size_t i = 0; i < model.parameters().axes.size(); ++i) {
    const AxisParameters& axis = model.parameters().axes[i];
    const double motor = motors[static_cast<Eigen::Index>(i)];
    if (motor >= axis.motor_min && motor <= axis.motor_max) continue;
    file.fail("home", "the motor of " + axis_text(axis) + " is at " + number_text(motor) + " rad there",
              config::expected_number({axis.motor_min, axis.motor_max}));
  }
  return motors;
}

}  // namespace

void check_models(const RobotModels& models, const config::Table& file) {
  const JointVector home_motors = check_home(*models.front(), file);
  for (const auto& model : models) {
    const ModelCheck check(*model, home_motors, file);
    check.check_motors();
    check.check_postures();
  }
  ModelCheck(*models.front(), home_motors, file).check_joint_limits();
}

}  // namespace mrroc::edp
