#include "config/entries/device_name.hpp"

#include <algorithm>
#include <array>

#include "config/text/message_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc::config {

namespace {

/// With `_edp` behind it, it is the name of a process.
constexpr std::size_t kDeviceNameLength = kNameLength - 4;

constexpr std::array<std::string_view, 3> kReserved{"mp", "sim", "operator"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_part_of_name(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

void check_name(const Table& table, std::string_view key, const std::string& name) {
  if (name.size() > kNameLength) {
    table.fail(key, in_quotes(name) + " has " + std::to_string(name.size()) + " characters",
               "at most " + std::to_string(kNameLength));
  }
  if (name.empty() || !is_letter(name.front()) || !std::all_of(name.begin(), name.end(), is_part_of_name)) {
    table.fail(key, in_quotes(name) + " is not a name", "a letter, then letters, digits and '_'");
  }
}

void check_device_name(const Table& table, const std::string& name) {
  check_name(table, name, name);
  if (name.size() > kDeviceNameLength) {
    table.fail(name, in_quotes(name) + " has " + std::to_string(name.size()) + " characters",
               "at most " + std::to_string(kDeviceNameLength));
  }
  if (std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end()) {
    table.fail(name, in_quotes(name) + " is reserved", "another name than 'mp', 'sim' and 'operator'");
  }
}

}  // namespace mrroc::config
