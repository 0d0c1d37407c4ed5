#include "drivers/socketcan/mode_display.hpp"

#include "canopen/objects.hpp"
#include "drivers/socketcan/ticks_of.hpp"

namespace mrroc::edp {

using canopen::SdoAbort;
using Status = canopen::SdoTransfer::Status;

ModeDisplay::ModeDisplay(canopen::NodeId node, canopen::Object object, bool there, double period) noexcept
    : node_(node),
      object_(object),
      there_(there),
      pause_ticks_(ticks_of(kPause, period)),
      answer_ticks_(ticks_of(kAnswerTime, period)) {}

void ModeDisplay::want(canopen::DriveMode mode) noexcept {
  wanted_ = mode;
  shown_.reset();
  due_ = 0;
}

bool ModeDisplay::asks(Tick tick, can::Frame& request) noexcept {
  if (confirms() || tick < due_) return false;
  request = transfer_.upload(node_, object_);
  asked_ = tick;
  due_ = tick + answer_ticks_;
  return true;
}

void ModeDisplay::take(const can::Frame& frame, can::Frame& next) noexcept {
  if (!transfer_.take(frame, next) || transfer_.status() == Status::waiting) return;
  due_ = asked_ + pause_ticks_;
  if (transfer_.status() == Status::done && !transfer_.value().empty())
    shown_ = static_cast<std::int8_t>(transfer_.value().front());
  // an EDS file of a family of drives
  if (transfer_.status() == Status::refused && transfer_.abort() == SdoAbort::no_such_object) there_ = false;
}

}  // namespace mrroc::edp
