#include "edp/safety/error_report.hpp"

namespace mrroc::edp {

ErrorReport make_report(const Fault& fault, const RobotParameters& parameters) noexcept {
  const auto tick = static_cast<unsigned long long>(fault.tick);
  const DriverText detail = describe(fault.detail);
  const char* const colon = detail.empty() ? "" : ": ";
  if (fault.axis < 0)
    return make_report(ErrorClass::hardware, fault.code, "at tick %llu%s%s", tick, colon, detail.c_str());
  const char* const name = parameters.axes[static_cast<std::size_t>(fault.axis)].name.c_str();
  return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu%s%s", fault.axis + 1, name, tick, colon,
                     detail.c_str());
}

}  // namespace mrroc::edp
