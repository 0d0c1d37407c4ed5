#pragma once

#include <map>
#include <string>
#include <vector>

namespace mrroc::config {

/// Values of the keys that a sensor type or a driver declares for itself (entries/declared_keys.hpp), checked, with
/// defaults filled in.
struct KeyValues {
  /// Of kind number, numbers, integer and boolean (1 or 0); one or more values each.
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::string> texts;  ///< of kind text

  /// The first number of `key`; throws std::out_of_range for a key that is not declared.
  double number(const std::string& key) const { return numbers.at(key).at(0); }
  bool on(const std::string& key) const { return number(key) != 0; }
  const std::string& text(const std::string& key) const { return texts.at(key); }
};

}  // namespace mrroc::config
