#pragma once

#include "clock/wall/tick_statistics.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "mrroc/robot_parameters.hpp"
#include "process/status_board.hpp"

namespace mrroc::edp {

/// Reports to operators in the status of an EDP: ticks, late commands, packages of a robot's clock, and the fault that
/// keeps the robot from moving. The effector's thread.
class RobotStatus {
 public:
  /// Both must outlive it.
  RobotStatus(process::StatusBoard& board, const RobotParameters& parameters) noexcept
      : board_(board), parameters_(parameters) {}

  /// `ticks`: times of the servo's wake-ups, of the real clock only. Does not allocate, lock or publish.
  void report(Effector& effector, Servo& servo, const clock::TickStatistics* ticks = nullptr) noexcept;

 private:
  process::StatusBoard& board_;
  const RobotParameters& parameters_;
  ErrorCode fault_ = ErrorCode::none;  ///< that is reported
};

}  // namespace mrroc::edp
