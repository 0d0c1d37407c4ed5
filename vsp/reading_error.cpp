#include "vsp/reading_error.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <limits>

namespace mrroc::vsp {

void report(SensorReading& v, ErrorClass error_class, ErrorCode code, const char* format, ...) noexcept {
  std::array<char, 192> detail{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(detail.data(), detail.size(), format, arguments);
  va_end(arguments);
  v.error.error_class = error_class;
  v.error.code = code;
  v.error.detail.assign(detail.data());
  v.values.fill(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace mrroc::vsp
