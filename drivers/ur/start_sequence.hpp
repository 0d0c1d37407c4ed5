#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "drivers/ur/dashboard_client.hpp"
#include "drivers/ur/options.hpp"
#include "drivers/ur/ur_fault.hpp"

namespace mrroc::ur {

/// The steps of one attempt to make the robot ready: protective stop, power, brakes, control script. Its time is that
/// of the caller. Waits for answers of the dashboard server, so it is not for a servo thread in real time.
class StartSequence {
 public:
  /// `program` holds the number of the control script that was started last, 0 before the first, which gets
  /// `first_program`. All references must outlive it. `begin`: now, ns.
  StartSequence(const UrOptions& options, const std::string& script, std::atomic<std::int32_t>& program,
                std::int32_t first_program, std::int64_t begin);

  /// Takes the next step. Nothing: the robot is not ready yet; monostate: it is ready. `frequency` of the program's
  /// periods, Hz. Throws ConnectionError.
  std::optional<UrFault> advance(const RobotState& state, double frequency, std::int64_t now);
  bool is_expired(std::int64_t now) const noexcept { return now > deadline_; }

 private:
  /// A command that is repeated until the robot's state has changed.
  class Repeated {
   public:
    bool due(std::int64_t now) noexcept;

   private:
    std::optional<std::int64_t> next_;
  };

  bool is_ready(const RobotState& state) const noexcept;
  DashboardClient& dashboard();
  void upload(double frequency);
  void await_program();

  const UrOptions& options_;
  const std::string& script_;
  std::atomic<std::int32_t>& program_;
  const std::int32_t first_program_;
  const std::int64_t deadline_;
  std::optional<DashboardClient> dashboard_;
  Repeated unlock_, power_, brakes_, upload_;
  std::string refusal_;  ///< of the dashboard
};

}  // namespace mrroc::ur
