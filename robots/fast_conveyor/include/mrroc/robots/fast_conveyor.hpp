#pragma once

#include <string>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The belt conveyor for speeds up to 0.15 m/s, as a task program declares it: `FastConveyor belt{*this};`. Its axis is
/// the travel of the endless belt in m; its pose is that of a mark on the belt, which goes along x of the base frame.
/// By position: `JointLine{belt, FastConveyor::at(1.5)}`; by velocity: `ToolVelocity{belt, {0.14, 0, 0}}`.
class FastConveyor : public Robot {
 public:
  /// `name`: as in the deployment; empty in an ECP: its own robot. Throws NonFatalError when the deployment has no such
  /// fast_conveyor, ConfigurationError when its parameter file is wrong.
  explicit FastConveyor(Task& task, const std::string& name = "");

  /// The belt having travelled `position` m.
  static JointVector at(double position);
};

}  // namespace mrroc
