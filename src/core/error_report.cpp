#include "core/error_report.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>

namespace mrroc {

ErrorReport make_report(ErrorClass error_class, ErrorCode code, const char* format, ...) noexcept {
  std::array<char, 192> text;
  va_list values;
  va_start(values, format);
  std::vsnprintf(text.data(), text.size(), format, values);
  va_end(values);
  return {error_class, code, std::string_view(text.data())};
}

}  // namespace mrroc
