#include "drivers/socketcan/drive_answers.hpp"

namespace mrroc::edp {

void DriveAnswers::begin() noexcept {
  in_service_ = answered_ = true;
  knows_switches_ = false;
  missed_ = unheard_ = without_status_ = 0;
}

void DriveAnswers::expect() noexcept {
  answered_ = false;
  outstanding_ = std::min(outstanding_ + 1, kMaxOutstanding);
}

bool DriveAnswers::take() noexcept {
  const bool first = !answered_this_cycle_;
  if (outstanding_ > 0)
    --outstanding_;
  else
    unexpected_ = true;
  answered_this_cycle_ = answered_ = true;
  unheard_ = 0;
  return first;
}

void DriveAnswers::take_status() noexcept {
  without_status_ = 0;
  knows_switches_ = true;
}

DriveAnswers::Cycle DriveAnswers::close() noexcept {
  const Cycle cycle = unexpected_ ? Cycle::too_many : answered_this_cycle_ ? Cycle::answer : Cycle::nothing;
  if (unexpected_) {
    answered_ = false;
    ++surplus_;
  } else if (!has_duplicate()) {
    surplus_ = 0;
  }
  answered_this_cycle_ = unexpected_ = false;
  if (in_service_) ++without_status_;
  if (answered_) missed_ = 0;
  if (answered_ || !in_service_) return cycle;
  ++unheard_;
  ++missed_;
  return cycle;
}

}  // namespace mrroc::edp
