#include "config/text/toml_text.hpp"

#include <algorithm>
#include <locale>
#include <sstream>
#include <utility>
#include <vector>

namespace mrroc::config {

namespace {

using Entry = std::pair<const toml::key*, const toml::node*>;

std::vector<Entry> in_file_order(const toml::table& table) {
  std::vector<Entry> entries;
  for (const auto& [key, node] : table) entries.emplace_back(&key, &node);
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.first->source().begin < b.first->source().begin; });
  return entries;
}

constexpr auto kAsTyped = toml::format_flags::allow_unicode_strings;  // else strings in double quotes, on one line

/// The key as a string, which TOML allows for every key.
std::string quoted(std::string_view key) {
  std::ostringstream text;
  text << toml::toml_formatter{toml::value<std::string>{std::string(key)}, kAsTyped};
  return text.str();
}

/// Arrays and inline tables are written here: toml++ 3.3 leaves the quotes of some of their keys and strings out.
void write_value(std::ostream& out, const toml::node& node) {
  const char* between = "";
  if (const toml::array* const array = node.as_array()) {
    out << '[';
    for (const toml::node& element : *array) {
      out << std::exchange(between, ", ");
      write_value(out, element);
    }
    out << ']';
  } else if (const toml::table* const table = node.as_table()) {
    out << '{';
    for (const auto& [key, value] : in_file_order(*table)) {
      out << std::exchange(between, ", ") << quoted(key->str()) << " = ";
      write_value(out, *value);
    }
    out << '}';
  } else {
    node.visit([&out](const auto& value) { out << toml::toml_formatter{value, kAsTyped}; });
  }
}

void write(std::ostream& out, const toml::table& table, const std::string& path) {
  const std::vector<Entry> entries = in_file_order(table);
  for (const auto& [key, node] : entries) {
    if (node->is_table()) continue;
    out << quoted(key->str()) << " = ";
    write_value(out, *node);
    out << '\n';
  }
  for (const auto& [key, node] : entries) {
    if (!node->is_table()) continue;
    const std::string full = path + (path.empty() ? "" : ".") + quoted(key->str());
    out << '[' << full << "]\n";
    write(out, *node->as_table(), full);
  }
}

}  // namespace

std::string toml_text(const toml::table& root) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  write(out, root, "");
  return out.str();
}

}  // namespace mrroc::config
