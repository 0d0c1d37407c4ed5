#pragma once

#include <string>

#include "config/text/message_text.hpp"
#include "mrroc/types.hpp"

/// Values as a TOML file has them.
namespace mrroc::cli {

/// A number that TOML reads as one with a point.
inline std::string toml_number(double value) {
  const std::string text = config::number_text(value + 0.0);  // without a sign of zero
  return text.find_first_of(".eni") == std::string::npos ? text + ".0" : text;
}

template <class Vector>
std::string toml_array(const Vector& values) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (i > 0) text += ", ";
    text += toml_number(values[i]);
  }
  return text + "]";
}

}  // namespace mrroc::cli
