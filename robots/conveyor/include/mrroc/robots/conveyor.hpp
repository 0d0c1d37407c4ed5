#pragma once

#include <string>

#include "mrroc/robot.hpp"

namespace mrroc {

/// A belt conveyor, as a task program declares it: `Conveyor belt{*this};`. Its axis is the travel of the endless belt
/// in m; its pose is that of a mark on the belt, which moves along x of the base frame. By position:
/// `JointLine{belt, Conveyor::at(1.5)}`; by velocity: `ToolVelocity{belt, {0.04, 0, 0}}`.
class Conveyor : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// conveyor, ConfigurationError when its parameter file is invalid.
  explicit Conveyor(Task& task, const std::string& name = "");

  /// The belt having travelled `position` m.
  static JointVector at(double position);
};

}  // namespace mrroc
