#include "edp/safety/fault.hpp"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "language/limits.hpp"

namespace mrroc::edp {
namespace {

struct Describe {
  DriverText operator()(std::monostate) const noexcept { return {}; }
  DriverText operator()(const Excess& excess) const noexcept {
    const int digits = digits_to_differ(std::abs(excess.value), std::abs(excess.limit));
    return driver_text("%.*g, limit %.*g", digits, excess.value, digits, excess.limit);
  }
  DriverText operator()(NotFinite) const noexcept { return driver_text("its reading is not a finite number"); }
  DriverText operator()(const ShaftPosition& shaft) const noexcept {
    return driver_text("at %.6g rad of the shaft", shaft.position);
  }
  DriverText operator()(const DriverText& text) const noexcept { return text; }
};

}  // namespace

DriverText describe(const FaultDetail& detail) noexcept { return std::visit(Describe{}, detail); }

DriverText driver_text(const char* format, ...) noexcept {
  std::array<char, 128> text;
  va_list values;
  va_start(values, format);
  std::vsnprintf(text.data(), text.size(), format, values);
  va_end(values);
  return std::string_view(text.data());
}

}  // namespace mrroc::edp
