#include "drivers/ur/lockstep_start.hpp"

#include <cmath>
#include <utility>

namespace mrroc::ur {

LockstepStart::LockstepStart(const UrOptions& options, const RtdeLink& link, std::string script)
    : options_(options), link_(link), script_(std::move(script)) {}

void LockstepStart::request() noexcept {
  running_ = true;
  sequence_.reset();
}

void LockstepStart::take(const RobotState& state) noexcept {
  try {
    const std::int64_t now = std::llround(state.timestamp * 1e9);
    if (!sequence_) sequence_.emplace(options_, script_, program_, 1, now);
    const std::optional<UrFault> result = sequence_->advance(state, link_.program_frequency(), now);
    if (!result) return;
    failure_ = *result;
  } catch (const std::exception& error) {
    failure_ = StartFailed{edp::DriverText(error.what())};
  }
  running_ = false;
  sequence_.reset();
}

}  // namespace mrroc::ur
