#include "drivers/socketcan/drive_fault.hpp"

#include "canopen/emergency.hpp"

namespace mrroc::edp {
namespace {

struct CodeOf {
  ErrorCode operator()(std::monostate) const noexcept { return ErrorCode::none; }
  template <class Kind>
  ErrorCode operator()(const Kind&) const noexcept {
    return Kind::kCode;
  }
};

const char* what_is_missing(Silent::How how) noexcept {
  switch (how) {
    case Silent::How::late:
      return "its answers come later than answer_time";
    case Silent::How::no_status:
      return "no TPDO 2, velocity and switches,";
    case Silent::How::no_answer:
      break;
  }
  return "no answer";
}

struct Describe {
  DriverText operator()(std::monostate) const noexcept { return {}; }
  DriverText operator()(Restarted) const noexcept { return {}; }
  DriverText operator()(const SetupRefused& refused) const noexcept {
    const std::string_view reason = canopen::describe(refused.reason);
    return driver_text("it refuses to be set up: object %04Xh:%u, %.*s", refused.object.index, refused.object.sub,
                       static_cast<int>(reason.size()), reason.data());
  }
  DriverText operator()(const DuplicateNode& duplicate) const noexcept {
    return driver_text("%d answers more than SYNCs: another node sends under its number", duplicate.cycles);
  }
  DriverText operator()(const Silent& silent) const noexcept {
    return driver_text("%s after more than %d SYNCs in a row", what_is_missing(silent.how), silent.allowed);
  }
  DriverText operator()(const HeartbeatLost& lost) const noexcept {
    return driver_text("the last one is %llu ticks old, limit %llu", static_cast<unsigned long long>(lost.age),
                       static_cast<unsigned long long>(lost.allowed));
  }
  DriverText operator()(const DriveError& error) const noexcept {
    if (error.code == 0) return driver_text("fault, no EMCY");
    const std::string_view text = canopen::error_text(error.code);
    return driver_text("error code %04Xh, %.*s", error.code, static_cast<int>(text.size()), text.data());
  }
  DriverText operator()(const WrongState& wrong) const noexcept {
    const std::string_view state = canopen::describe(canopen::drive_state(wrong.statusword));
    return driver_text("statusword %04Xh, %.*s", wrong.statusword, static_cast<int>(state.size()), state.data());
  }
  DriverText operator()(const WrongMode& wrong) const noexcept {
    const int wanted = static_cast<int>(wrong.wanted);
    if (!wrong.shown) return driver_text("no answer with its mode display (6061h), wanted %d", wanted);
    return driver_text("mode display %d, wanted %d", *wrong.shown, wanted);
  }
  DriverText operator()(NotFollowing) const noexcept { return driver_text("reported by its drive"); }
};

}  // namespace

ErrorCode code_of(const DriveFault& fault) noexcept { return std::visit(CodeOf{}, fault); }
DriverText describe(const DriveFault& fault) noexcept { return std::visit(Describe{}, fault); }

}  // namespace mrroc::edp
