#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "sim/ur/arm_motion.hpp"
#include "sim/ur/registers.hpp"

namespace mrroc::sim::ur {

/// The parts of the controller that a running program uses.
struct ProgramSurroundings {
  Registers& registers;
  ArmMotion& motion;
  const JointPlant& plant;
  double period;  ///< s
};

/// A program that runs on the simulated controller. This is not an interpreter of URScript: programs are recognised by
/// the name of their function, and their behaviour is written here in C++.
class Program {
 public:
  virtual ~Program() = default;
  /// One period; false: it has ended.
  virtual bool step(ProgramSurroundings& surroundings) = 0;
  /// Name of its function.
  virtual std::string_view name() const = 0;
};

/// The program of this text:
///
///   def mrroc_control():   the control script of drivers/ur, with its numbers read from the text
///   def rtde_control():    the control script of the client library ur_rtde: movej, servoj, speedj, their stops
///   any other              it runs for a short time and does nothing
///   a single line          single_command.hpp
///
/// Throws std::invalid_argument when the text is not a program, or lacks a number.
std::unique_ptr<Program> make_program(const std::string& text);

}  // namespace mrroc::sim::ur
