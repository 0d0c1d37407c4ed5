#pragma once

#include <atomic>
#include <cstdint>

#include "drivers/ur/robot_state.hpp"
#include "drivers/ur/ur_fault.hpp"

namespace mrroc::ur {

/// Makes the robot ready, whatever its present state: connection, protective stop, power, brakes, control script
/// (`StartSequence`). Servo thread.
class RobotStart {
 public:
  virtual ~RobotStart() = default;
  /// Starts, or repeats when it is running. Does not block.
  virtual void request() noexcept = 0;
  /// A request is not finished.
  virtual bool is_running() const noexcept = 0;
  /// Why the last request has failed; while `is_running` is false.
  virtual const UrFault& failure() noexcept = 0;
  /// Gives it the state of the present tick while `is_running`.
  virtual void take(const RobotState& /*state*/) noexcept {}

  /// Number of the control script that runs; 0: none has been started.
  std::int32_t program() const noexcept { return program_.load(std::memory_order_acquire); }

 protected:
  std::atomic<std::int32_t> program_{0};
};

}  // namespace mrroc::ur
