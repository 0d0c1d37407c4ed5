#pragma once

#include <string>

namespace mrroc {

/// For names: at most six decimals, without the zeros at the end: 0.15, 100.
inline std::string short_number(double value) {
  std::string text = std::to_string(value);
  if (text.find('.') == std::string::npos) return text;  // inf, nan
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace mrroc
