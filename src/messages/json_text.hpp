#pragma once

#include <string>
#include <type_traits>

#include "messages/cdr_writer.hpp"

namespace mrroc::messages {

/// Append a value as JSON: a floating-point number in the shortest form that reads back to the same bits, null where it
/// is not finite; a text in UTF-8 with the escapes that JSON requires.
void append_json(std::string& text, double value);
void append_json(std::string& text, const std::string& value);
inline void append_json(std::string& text, bool value) { text += value ? "true" : "false"; }
template <std::integral Value>
requires(!std::same_as<Value, bool>) void append_json(std::string& text, Value value) { text += std::to_string(value); }

/// As a list: `values` is an array or a vector.
template <class Values>
void append_json_list(std::string& text, const Values& values) {
  text += '[';
  bool first = true;
  for (const auto& value : values) {
    if (!first) text += ',';
    first = false;
    append_json(text, value);
  }
  text += ']';
}

}  // namespace mrroc::messages
