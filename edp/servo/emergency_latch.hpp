#pragma once

#include <optional>

#include "clock/emergency_stop.hpp"
#include "mrroc/signals.hpp"

namespace mrroc::edp {

/// The latched emergency stop of one robot: pressed by the operator (clock::EmergencyStop) or by a digital input of the
/// robot's controller, which is active low, so that a broken wire presses it. It stays latched until the operator has
/// reset it, after every input that presses it has been released; a reset before or together with a press
/// is ignored. The servo's thread; allocates nothing, never throws, never waits.
class EmergencyLatch {
 public:
  /// Both before the first check. `stop` must outlive this object.
  void use(const clock::EmergencyStop& stop) noexcept { stop_ = &stop; }
  /// Terminal 0..15.
  void use_terminal(int terminal) noexcept { terminal_ = terminal; }

  /// The inputs of a tick. True: latched.
  bool check(const ControllerIo& inputs) noexcept {
    const std::uint32_t resets = stop_ != nullptr ? stop_->resets() : 0;  // first: a press after it is not lost
    const std::uint32_t presses = stop_ != nullptr ? stop_->presses() : 0;
    if (presses != presses_ || (terminal_ && !inputs.on(*terminal_))) {
      latched_ = true;
      presses_ = presses;
    } else if (resets != resets_) {
      latched_ = false;
    }
    resets_ = resets;
    return latched_;
  }

 private:
  const clock::EmergencyStop* stop_ = nullptr;
  std::optional<int> terminal_;
  std::uint32_t presses_ = 0;
  std::uint32_t resets_ = 0;
  bool latched_ = false;
};

}  // namespace mrroc::edp
