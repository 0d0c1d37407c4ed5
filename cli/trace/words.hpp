#pragma once

#include <sstream>
#include <string>

#include "cli/trace/line.hpp"

namespace mrroc::cli::trace {

/// Concatenates its arguments, as a stream writes them; numbers with all their digits.
template <class... Parts>
std::string words(const Parts&... parts) {
  std::ostringstream text;
  text.precision(17);
  (text << ... << parts);
  return text.str();
}

/// "0.1,0.2"
inline std::string words_of(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) text.append(text.empty() ? "" : ",").append(words(number));
  return text;
}

}  // namespace mrroc::cli::trace
