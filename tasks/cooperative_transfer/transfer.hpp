#pragma once

#include <cstdio>
#include <mrroc/generators/cooperative_motion.hpp>
#include <mrroc/generators/together.hpp>
#include <mrroc/mp.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/robots/two_finger_gripper.hpp>
#include <mrroc/sensors/force_torque.hpp>
#include <mrroc/sensors/tracker.hpp>
#include <vector>

#include "transfer_path.hpp"

namespace mrroc::transfer {

/// Two arms of the class `Arm` that carry a bar together, and the parts of such a task. The wrenches in their wrists
/// control the internal force.
template <class Arm>
class TransferBy : public mp::Task {
 protected:
  explicit TransferBy(const Arms& carriers) : arms(carriers) {}

  /// Whether the internal force is controlled here, by the wrists of both arms; else only their motion.
  virtual bool controls_force() const { return true; }
  /// Both grippers hold the bar; they will open.
  virtual void gripped() {}
  virtual void before_release() {}

  /// Sets the grips as the arms' tools. Once, before the bar is taken up.
  void set_tools() {
    for (Arm* arm : {&left, &right}) arm->set_tool(arm->kinematics().tool() * left_gripper.grip_centre());
  }
  /// Grips the bar that lies at the beginning of way::lift() and lifts it. Throws NonFatalError(task_failed): no bar.
  void take_up() {
    Move({left, right, left_gripper, right_gripper}, {}, Together{reach(way::lift()[0], 0.1), grippers_to(kOpen)});
    Move({left, right}, {}, reach(way::lift()[0], 0));
    const Outcome grip = Move({left, right, left_gripper, right_gripper}, sensors,
                              grippers_to(kClosed).until(Gripped{left_gripper} && Gripped{right_gripper}));
    grip.require<Gripped>("no bar between the fingers");

    gripped();

    // release the internal force of the grippers
    Move({left, right}, sensors, carry({way::lift()[0]}, kFree).until(ElapsedSteps{50}));
    Move({left, right}, sensors, carry(way::lift(), kNear));
    borne = weight();
  }
  /// Carries the gripped bar along a path that begins where it is. Throws NonFatalError: the bar is lost.
  Outcome carry_along(const std::vector<Pose>& path, const CooperativeLimits& limits) {
    const When lost{"the bar is lost", [this] { return weight() < 0.5 * borne; }};
    Outcome way = Move({left, right}, sensors, carry(path, limits).until(lost));
    if (way.by<When>()) throw NonFatalError{"the bar has been lost"};
    return way;
  }
  /// Lowers the bar along a path onto the stands, releases it, and moves home.
  void put_down(const std::vector<Pose>& path) {
    Move({left, right}, sensors,
         carry(path, kTouch).until(When{"it stands", [this] { return weight() < 0.5 * borne; }}));
    before_release();
    Move({left, right, left_gripper, right_gripper}, {}, grippers_to(kOpen));
    Move({left, right}, {}, reach(path.front(), 0.1));
    Move({left, right}, {},
         Together{JointLine{left, left.parameters().home}, JointLine{right, right.parameters().home}});
  }

  const Arms arms;

 private:
  Arm left{*this, "left"}, right{*this, "right"};
  TwoFingerGripper left_gripper{*this, "left_gripper"}, right_gripper{*this, "right_gripper"};
  ForceTorque left_wrist{*this, "left_wrist"}, right_wrist{*this, "right_wrist"};
  Tracker tracker{*this, "tracker"};  // of the bar, for the trace only

  const SensorList sensors{left_wrist, right_wrist, tracker};
  static constexpr double kOpen = 0.072, kClosed = 0.057;               // m, between the pads; the bar is 0.060 wide
  static constexpr double kToolMass = 2.04;                             // kg, beyond the wrist
  const Eigen::Vector3d tool_centre{0.0022, 0.0021, arms.tool_centre};  // m, in the wrist's frame
  const Pose grip_in_wrist{Eigen::Translation3d(0, 0, arms.grip)};

  Pose base(const Robot& robot) const { return process().deployment().robot(robot.name()).known_base(); }

  /// The wrench of the bar on the arm's grip: the wrist's reading without the weight of the tool.
  Wrench of_bar(const Robot& arm, const ForceTorque& wrist) const {
    const Eigen::Vector3d weight = arm.state().pose.linear().transpose() * Eigen::Vector3d(0, 0, -9.81 * kToolMass);
    Wrench wrench = wrist.in(grip_in_wrist);
    wrench.head<3>() -= weight;
    wrench.tail<3>() -= (tool_centre - grip_in_wrist.translation()).cross(weight);
    return wrench;
  }
  /// Weight of the bar on one arm, and on both, N.
  double weight_on(const Robot& arm, const ForceTorque& wrist) const {
    const Wrench wrench = of_bar(arm, wrist);
    return -(arm.state().pose.linear() * wrench.head<3>()).z();
  }
  double weight() const { return weight_on(left, left_wrist) + weight_on(right, right_wrist); }

  /// Moves both arms to their grips of a bar at `bar`, `above` m over them.
  Together reach(const Pose& bar, double above) {
    const auto at = [&](Arm& arm, double y) {
      const Pose grip = bar * Eigen::Translation3d(0, y, above) * Arm::tool_down(0, 0, 0);
      return JointLine{arm, base(arm).inverse() * grip, 0.7};
    };
    return Together{at(left, kGrip), at(right, -kGrip)};
  }
  Together grippers_to(double opening) {
    return Together{JointLine{left_gripper, TwoFingerGripper::at(opening), 1.0},
                    JointLine{right_gripper, TwoFingerGripper::at(opening), 1.0}};
  }
  CooperativeMotion carry(const std::vector<Pose>& path, const CooperativeLimits& limits) {
    std::function<Wrench()> at_left, at_right;
    if (controls_force()) {
      at_left = [this] { return of_bar(left, left_wrist); };
      at_right = [this] { return of_bar(right, right_wrist); };
    }
    return {{{&left, base(left), at_left}, {&right, base(right), at_right}}, path, limits};
  }
  double borne = 0;  // N, weight of the bar after the lift
};

/// By two arms of six axes.
struct Transfer : TransferBy<Irb6> {
  Transfer() : TransferBy(kSixAxes) {}
};

}  // namespace mrroc::transfer
