// A robot of any type without known positions: it may move its motors slowly, synchronises, and then moves to its
// target. Prints that target for the test, which compares it with the simulated world.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "mrroc/ecp.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/robots/irb6.hpp"
#include "mrroc/robots/irb60.hpp"
#include "mrroc/robots/irb6_five_axis.hpp"
#include "mrroc/robots/irb6_track.hpp"
#include "mrroc/robots/serial_parallel.hpp"
#include "mrroc/robots/two_finger_gripper.hpp"
#include "require.hpp"

using namespace mrroc;
using mrroc::test::require;

namespace {

template <class Type>
std::unique_ptr<Robot> make(ecp::Task& task) {
  return std::make_unique<Type>(task);
}

/// The robot of the deployment.
std::unique_ptr<Robot> robot_of(ecp::Task& task) {
  const std::map<std::string, std::function<std::unique_ptr<Robot>(ecp::Task&)>> types{
      {"irb6", make<Irb6>},
      {"irb60", make<Irb60>},
      {"irb6_five_axis", make<Irb6FiveAxis>},
      {"irb6_track", make<Irb6Track>},
      {"serial_parallel", make<SerialParallel>},
      {"two_finger_gripper", make<TwoFingerGripper>}};
  return types.at(task.process().deployment().robots.front().type)(task);
}

/// One macrostep that turns every motor by this angle.
class Turn : public Generator {
 public:
  Turn(Robot& robot, JointVector by) : Generator("Turn"), robot_(robot), by_(std::move(by)) {}
  bool terminal_condition() override { return done_; }
  void next_state() override {
    robot_.command().kind = CommandKind::motor;
    robot_.command().relative = true;
    robot_.command().joints = by_;
    done_ = true;
  }

 private:
  Robot& robot_;
  JointVector by_;
  bool done_ = false;
};

class Synchronise : public ecp::Task {
  std::unique_ptr<Robot> owner = robot_of(*this);
  Robot& robot = *owner;

  /// Macrosteps until the regulators hold the weight, or until a motion has settled: 3 s.
  static constexpr int kSettled = 150;

  /// Largest of `values` per axis, in units of the axis's `tolerance`.
  template <class Tolerance>
  double worst(const JointVector& values, Tolerance tolerance) const {
    double result = 0;
    for (Eigen::Index i = 0; i < values.size(); ++i)
      result = std::max(result, std::abs(values[i]) / tolerance(robot.parameters().axes[static_cast<std::size_t>(i)]));
    return result;
  }
  static double two_increments(const AxisParameters& axis) {
    return 2 * 2 * std::numbers::pi / axis.encoder_increments;
  }

  void refuses_joints() {
    try {
      Move({robot}, {}, JointLine(robot, robot.parameters().home));
    } catch (const NonFatalError& error) {
      if (error.code() != ErrorCode::not_synchronised) throw;
      return;
    }
    require(false, "it moved its joints before it was synchronised");
  }

  void turns_slowly() {
    Wait({robot}, {}, ElapsedSteps{kSettled});
    const JointVector before = robot.state().motors;
    JointVector by(before.size());
    for (Eigen::Index i = 0; i < by.size(); ++i)
      by[i] = 0.2 * robot.parameters().axes[static_cast<std::size_t>(i)].synchro_coarse;
    robot.set_macrostep(500, 500);
    Turn turn(robot, by);
    Move({robot}, {}, turn);
    robot.set_macrostep(10, 8);
    Wait({robot}, {}, ElapsedSteps{kSettled});
    require(worst(robot.state().motors - before - by, two_increments) <= 1, "its motors did not turn as commanded");
    require(!robot.state().synchronised, "it is synchronised by turning");
  }

  void run() override {
    refuses_joints();
    turns_slowly();
    const double start = static_cast<double>(tick()) * servo_period();
    robot.synchronise();
    std::printf("synchronised in %.1f s\n", static_cast<double>(tick()) * servo_period() - start);
    require(robot.state().synchronised, "it is not synchronised");
    JointVector synchro(robot.state().motors.size()), target = robot.parameters().home;
    for (Eigen::Index i = 0; i < synchro.size(); ++i) {
      const AxisParameters& axis = robot.parameters().axes[static_cast<std::size_t>(i)];
      synchro[i] = axis.motor_synchro;
      // towards the middle of its range, so that no motor comes near its limit
      target[i] += 0.05 * (axis.position_min / 2 + axis.position_max / 2 - target[i]);
    }
    const auto stop = [](const AxisParameters& axis) { return 0.5 + 0.15 * std::abs(axis.synchro_fine); };
    require(worst(robot.state().motors - synchro, stop) < 1, "a motor is far from its synchronisation position");

    Move({robot}, {}, JointLine(robot, target));
    Wait({robot}, {}, ElapsedSteps{kSettled});
    JointVector motors;
    require(robot.models().front()->joints_to_motors(target, motors) == ErrorCode::none, "no motors for the target");
    require(worst(robot.state().motors - motors, two_increments) <= 1, "it did not reach its target");
    std::printf("target");
    for (const double joint : target) std::printf(" %.17g", joint);
    std::printf("\n");
  }
};

}  // namespace

MRROC_ECP(Synchronise)
