#include "edp/error_report.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>

namespace mrroc::edp {

ErrorReport make_report(ErrorClass error_class, ErrorCode code, const char* format, ...) noexcept {
  std::array<char, 192> text;
  va_list values;
  va_start(values, format);
  std::vsnprintf(text.data(), text.size(), format, values);
  va_end(values);
  return {error_class, code, std::string_view(text.data())};
}

ErrorReport make_report(const Fault& fault, const RobotParameters& parameters) noexcept {
  const auto tick = static_cast<unsigned long long>(fault.tick);
  if (fault.axis < 0) return make_report(ErrorClass::hardware, fault.code, "at tick %llu", tick);
  const char* const name = parameters.axes[static_cast<std::size_t>(fault.axis)].name.c_str();
  if (fault.code == ErrorCode::limit_switch)
    return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu: at %.6g rad of the shaft",
                       fault.axis + 1, name, tick, fault.value);
  return make_report(ErrorClass::hardware, fault.code, "axis %d (%s), tick %llu: %.6g, limit %.6g", fault.axis + 1,
                     name, tick, fault.value, fault.limit);
}

}  // namespace mrroc::edp
