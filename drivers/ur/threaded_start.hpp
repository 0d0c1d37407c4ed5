#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "core/lockfree/latest_value.hpp"
#include "drivers/ur/options.hpp"
#include "drivers/ur/robot_start.hpp"
#include "drivers/ur/rtde_link.hpp"

namespace mrroc::ur {

/// The dashboard and the secondary interface answer slowly, some commands after seconds, so in real time this is a
/// thread of its own.
class ThreadedStart final : public RobotStart {
 public:
  /// `script` is the control script, checked by `control_program`; `link` must outlive it.
  ThreadedStart(const UrOptions& options, RtdeLink& link, std::string script);
  ~ThreadedStart() override;
  ThreadedStart(const ThreadedStart&) = delete;
  ThreadedStart& operator=(const ThreadedStart&) = delete;

  /// One system call, which does not block.
  void request() noexcept override;
  bool is_running() const noexcept override;
  const UrFault& failure() noexcept override;

 private:
  void run() noexcept;
  UrFault start();
  bool pause() noexcept;

  const UrOptions options_;
  RtdeLink& link_;
  const std::string script_;
  std::atomic<std::uint32_t> requested_{0}, finished_{0};
  std::atomic<bool> end_{false};
  core::LatestValue<UrFault> failure_;
  int wake_ = -1;  ///< eventfd
  std::thread thread_;
};

}  // namespace mrroc::ur
