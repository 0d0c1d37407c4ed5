#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "core/lockfree/latest_value.hpp"
#include "drivers/ur/options.hpp"
#include "drivers/ur/rtde_link.hpp"
#include "drivers/ur/ur_fault.hpp"

namespace mrroc::ur {

/// Makes the robot ready, whatever its present state: connection, protective stop, power, brakes, control script. The
/// dashboard and the secondary interface answer slowly, some commands after seconds, so this is a thread of its own.
class RobotStart {
 public:
  /// `script` is the control script, checked by `control_program`; `link` must outlive it.
  RobotStart(const UrOptions& options, RtdeLink& link, std::string script);
  ~RobotStart();
  RobotStart(const RobotStart&) = delete;
  RobotStart& operator=(const RobotStart&) = delete;

  /// Starts, or repeats when it is running. Servo thread. One system call, which does not block.
  void request() noexcept;
  /// A request is not finished. Servo thread.
  bool is_running() const noexcept;
  /// Why the last request has failed. Servo thread, while `is_running` is false.
  const UrFault& failure() noexcept;
  /// Number of the control script that runs; 0: none has been started. Servo thread.
  std::int32_t program() const noexcept { return program_.load(std::memory_order_acquire); }

 private:
  void run() noexcept;
  UrFault start();
  bool pause() noexcept;
  bool is_ready(const RobotState& state) const noexcept;

  const UrOptions options_;
  RtdeLink& link_;
  const std::string script_;
  std::atomic<std::uint32_t> requested_{0}, finished_{0};
  std::atomic<std::int32_t> program_{0};
  std::atomic<bool> end_{false};
  core::LatestValue<UrFault> failure_;
  int wake_ = -1;  ///< eventfd
  std::thread thread_;
};

}  // namespace mrroc::ur
