#include "edp/safety/error_report.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "can/bus_error.hpp"
#include "canopen/drive_state.hpp"
#include "canopen/emergency.hpp"
#include "canopen/sdo.hpp"
#include "edp/safety/drive_silence.hpp"
#include "language/limits.hpp"

namespace mrroc::edp {

namespace {

/// `value` of the fault is the mode that the drive shows, a number of 8 bits if it has shown any; `limit` that which it
/// was told.
ErrorReport make_mode_report(const Fault& fault, const char* name) noexcept {
  const auto tick = static_cast<unsigned long long>(fault.tick);
  if (std::abs(fault.value) <= 128)
    return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu: mode display %.0f, wanted %.0f",
                       fault.axis + 1, name, tick, fault.value, fault.limit);
  return make_report(ErrorClass::hardware, fault.code,
                     "axis %d (%s), tick %llu: no answer with its mode display (6061h), wanted %.0f", fault.axis + 1,
                     name, tick, fault.limit);
}

/// `value` of the fault is the drive's error code (603Fh), 0 for none, or its statusword where it is not ready.
ErrorReport make_drive_report(const Fault& fault, const char* name) noexcept {
  const bool ready = fault.code == ErrorCode::drive_fault;
  if (!ready && fault.limit != 0) return make_mode_report(fault, name);
  if (ready && fault.value == 0)
    return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu: fault, no EMCY", fault.axis + 1,
                       name, static_cast<unsigned long long>(fault.tick));
  const auto code = static_cast<std::uint16_t>(fault.value);
  const std::string_view text = ready ? canopen::error_text(code) : canopen::describe(canopen::drive_state(code));
  return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu: %s%04Xh, %.*s", fault.axis + 1, name,
                     static_cast<unsigned long long>(fault.tick), ready ? "error code " : "statusword ", code,
                     static_cast<int>(text.size()), text.data());
}

/// `value` of the fault is the object that the drive refuses to be given, or 0; `limit` its reason.
ErrorReport make_restart_report(const Fault& fault, const char* name) noexcept {
  const auto tick = static_cast<unsigned long long>(fault.tick);
  if (fault.value == 0)
    return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu", fault.axis + 1, name, tick);
  const auto object = static_cast<std::uint32_t>(fault.value);
  const std::string_view why = canopen::describe(static_cast<canopen::SdoAbort>(fault.limit));
  return make_report(ErrorClass::hardware, fault.code,
                     "axis %d (%s), tick %llu: it refuses to be set up: object %04Xh:%u, %.*s", fault.axis + 1, name,
                     tick, object >> 8, object & 0xff, static_cast<int>(why.size()), why.data());
}

/// `value` of the fault is a DriveSilence, `limit` the SYNCs in a row that may be left so.
ErrorReport make_silence_report(const Fault& fault, const char* name) noexcept {
  const auto silence = static_cast<DriveSilence>(fault.value);
  const char* const how = silence == DriveSilence::late        ? "its answers come later than answer_time"
                          : silence == DriveSilence::no_status ? "no TPDO 2, velocity and switches,"
                                                               : "no answer";
  return make_report(ErrorClass::hardware, fault.code,
                     "axis %d (%s), tick %llu: %s after more than %.0f SYNCs in a row", fault.axis + 1, name,
                     static_cast<unsigned long long>(fault.tick), how, fault.limit);
}

}  // namespace

ErrorReport make_report(const Fault& fault, const RobotParameters& parameters) noexcept {
  const auto tick = static_cast<unsigned long long>(fault.tick);
  if (fault.code == ErrorCode::bus_off || fault.code == ErrorCode::bus_error)
    return make_report(ErrorClass::hardware, fault.code, "at tick %llu: %s", tick,
                       can::describe(static_cast<can::BusError>(fault.value)));
  if (fault.code == ErrorCode::hardware_silent && fault.value == static_cast<double>(DriveSilence::nobody))
    return make_report(
        ErrorClass::hardware, fault.code,
        "at tick %llu: no drive has answered more than %.0f SYNCs in a row: they are lost, or the bus is cut", tick,
        fault.limit);
  if (fault.axis < 0) return make_report(ErrorClass::hardware, fault.code, "at tick %llu", tick);
  const char* const name = parameters.axes[static_cast<std::size_t>(fault.axis)].name.c_str();
  if (fault.code == ErrorCode::limit_switch)
    return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu: at %.6g rad of the shaft",
                       fault.axis + 1, name, tick, fault.value);
  if (fault.code == ErrorCode::drive_fault || fault.code == ErrorCode::drive_not_ready)
    return make_drive_report(fault, name);
  if (fault.code == ErrorCode::hardware_silent) return make_silence_report(fault, name);
  if (fault.code == ErrorCode::drive_restarted) return make_restart_report(fault, name);
  if (fault.code == ErrorCode::encoder_fault && fault.limit == 0)
    return make_report(ErrorClass::hardware, fault.code,
                       "axis %d (%s), tick %llu: %.0f answers more than SYNCs: another node sends under its number",
                       fault.axis + 1, name, tick, fault.value);
  if (fault.code == ErrorCode::following_error && fault.limit == 0)
    return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu: told by its drive", fault.axis + 1,
                       name, tick);
  const int digits = digits_to_differ(std::abs(fault.value), std::abs(fault.limit));
  return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu: %.*g, limit %.*g", fault.axis + 1,
                     name, tick, digits, fault.value, digits, fault.limit);
}

}  // namespace mrroc::edp
