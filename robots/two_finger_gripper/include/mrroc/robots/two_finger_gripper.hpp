#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The IRb-6's two-finger gripper, as a task program declares it: `TwoFingerGripper gripper{*this, "gripper"};`. Its
/// axis is the opening, the clear width between the pads in m. To grip, close to up to 4 mm less than the part is wide
/// until `Gripped`: the servo then presses with its full force, some 190 N.
class TwoFingerGripper : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// gripper, ConfigurationError when its parameter file is invalid.
  explicit TwoFingerGripper(Task& task, const std::string& name = "");

  /// Opened to `opening` m.
  static JointVector at(double opening);
  /// The middle between the pads, in the gripper's base frame. With the gripper at an arm's tool frame, the arm's tool
  /// pose that brings it to `pose` is `pose * grip_centre().inverse()`.
  Pose grip_centre() const;
  /// Opening beyond the set-point, m: at half a millimetre or more an object is between the fingers. Of
  /// the moment to which the desired state belongs, so that it is 0 in free motion. NaN before the first
  /// state.
  double held_open() const;
};

/// An object between the pads holds them open by more than half a millimetre. `!Gripped{gripper}`: it has been lost.
class Gripped : public Condition {
 public:
  explicit Gripped(const TwoFingerGripper& gripper);

 protected:
  bool holds() override;

 private:
  const TwoFingerGripper* gripper_;
};

}  // namespace mrroc
