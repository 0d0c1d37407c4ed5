#pragma once

#include <optional>
#include <string>

#include "drivers/ur/options.hpp"
#include "drivers/ur/robot_start.hpp"
#include "drivers/ur/rtde_link.hpp"
#include "drivers/ur/start_sequence.hpp"

namespace mrroc::ur {

/// In lockstep each tick takes one step of the start and waits for the answers of the stand-in, which stands still
/// meanwhile. Its time is that of the stand-in.
class LockstepStart final : public RobotStart {
 public:
  /// `script` is the control script, checked by `control_program`; `link` must outlive it.
  LockstepStart(const UrOptions& options, const RtdeLink& link, std::string script);

  void request() noexcept override;
  bool is_running() const noexcept override { return running_; }
  const UrFault& failure() noexcept override { return failure_; }
  void take(const RobotState& state) noexcept override;

 private:
  const UrOptions options_;
  const RtdeLink& link_;
  const std::string script_;
  bool running_ = false;
  std::optional<StartSequence> sequence_;
  UrFault failure_;
};

}  // namespace mrroc::ur
