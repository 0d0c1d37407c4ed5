#include "config/table.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"
#include "config/text/toml_parser.hpp"
#include "core/nearest_word.hpp"
#include "core/text_lines.hpp"

namespace mrroc::config {

struct Document {
  std::filesystem::path file;
  toml::table root;
};

namespace {

int line_of(const toml::source_region& place) { return static_cast<int>(place.begin.line); }

/// The bound on a line's length also bounds the depth of dotted keys, and so the parser's recursion.
void check_lines(const std::filesystem::path& file, std::string_view text) {
  try {
    for (core::TextLines lines(text); lines.next();) {
    }
  } catch (const core::TextError& error) {
    throw ConfigurationError(file, error.line, "", error.problem, error.expected);
  }
}

/// `path.key`, the key in quotes if TOML would need them.
std::string join(const std::string& path, std::string_view key) {
  const auto is_bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), is_bare);
  const std::string last = bare ? std::string(key) : in_quotes(key);
  return path.empty() ? last : path + "." + last;
}

/// "'abc' is a text", "0.5 is a number", "is a table": the value found where another type was expected.
std::string found(const toml::node& node) {
  if (const auto* value = node.as_string()) return in_quotes(value->get()) + " is a text";
  if (const auto* value = node.as_integer()) return std::to_string(value->get()) + " is an integer";
  if (const auto* value = node.as_floating_point()) return number_text(value->get()) + " is a number";
  if (const auto* value = node.as_boolean()) return std::string(value->get() ? "true" : "false") + " is a boolean";
  if (node.is_table()) return "is a table";
  if (node.is_array()) return "is an array";
  return "is a date or a time";
}

/// Whether `word` is `key` with one letter dropped or doubled or two letters swapped: a typing error. (A replaced
/// letter is not: `regulator_b0` and `regulator_b1` are two keys.)
bool is_slip(std::string word, std::string key) {
  if (core::edit_distance(word, key) != 1) return false;
  if (word.size() != key.size()) return true;
  std::sort(word.begin(), word.end());
  std::sort(key.begin(), key.end());
  return word == key;
}

}  // namespace

struct Table::Node {
  std::shared_ptr<const Document> document;
  const toml::table* table;
  std::string path;  // full key of this table; empty for the root
  int header_line;
  mutable std::set<std::string, std::less<>> asked;

  std::shared_ptr<const Node> child(const toml::table& sub_table, std::string sub_path, int line) const {
    return std::make_shared<const Node>(Node{document, &sub_table, std::move(sub_path), line, {}});
  }

  /// The value of `key`, which is marked as used; null when missing.
  const toml::node* find(std::string_view key) const {
    asked.emplace(key);
    return table->get(key);
  }

  const toml::node& require(std::string_view key, const std::string& expected) const {
    if (const auto* node = find(key)) return *node;
    for (const auto& [name, value] : *table) {
      const std::string word{name.str()};
      if (!asked.contains(word) && is_slip(word, std::string(key))) refuse_unknown(name, std::string(key));
    }
    fail(header_line, join(path, key), "missing", expected);
  }

  [[noreturn]] void fail(int line, const std::string& full_key, const std::string& problem,
                         const std::string& expected) const {
    throw ConfigurationError(document->file, line, full_key, problem, expected);
  }

  [[noreturn]] void fail(const toml::node& node, const std::string& full_key, const std::string& problem,
                         const std::string& expected) const {
    fail(line_of(node.source()), full_key, problem, expected);
  }

  [[noreturn]] void refuse_unknown(const toml::key& key, const std::string& suggestion) const {
    const std::string problem = "unknown key";
    const std::string full_key = join(path, key.str());
    const int line = line_of(key.source());
    if (!suggestion.empty()) fail(line, full_key, problem + ", did you mean " + in_quotes(suggestion) + "?", "");
    const std::vector<std::string> known(asked.begin(), asked.end());
    fail(line, full_key, problem, known.empty() ? "no keys here" : alternatives(known));
  }

  double number(const toml::node& node, const std::string& full_key, Range range) const {
    const auto value = node.value<double>();
    if (!node.is_number() || !value) fail(node, full_key, found(node), expected_number(range));
    if (!std::isfinite(*value)) fail(node, full_key, number_text(*value) + " is not finite", expected_number(range));
    if (*value < range.min || *value > range.max) {
      fail(node, full_key, number_text(*value) + " is out of range", expected_number(range));
    }
    return *value;
  }
};

Table::Table(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

Table Table::load(const std::filesystem::path& file) { return parse(file, read_file(file)); }

Table Table::parse(const std::filesystem::path& file, const std::string& text) {
  check_lines(file, text);
  try {
    const auto document = std::make_shared<const Document>(Document{file, toml::parse(core::without_dos_end(text))});
    return Table(std::make_shared<const Node>(Node{document, &document->root, "", 1, {}}));
  } catch (const toml::parse_error& error) {
    throw ConfigurationError(file, line_of(error.source()), "column " + std::to_string(error.source().begin.column),
                             std::string(error.description()), "valid TOML");
  }
}

bool Table::has(std::string_view key) const { return node_->find(key) != nullptr; }

std::string Table::text(std::string_view key) const {
  const auto& node = node_->require(key, "a text");
  if (!node.is_string()) node_->fail(node, join(node_->path, key), found(node), "a text");
  return node.as_string()->get();
}

std::optional<std::string> Table::optional_text(std::string_view key) const {
  return has(key) ? std::optional(text(key)) : std::nullopt;
}

std::string Table::choice(std::string_view key, const std::vector<std::string>& choices) const {
  const auto& node = node_->require(key, alternatives(choices));
  if (!node.is_string()) node_->fail(node, join(node_->path, key), found(node), alternatives(choices));
  const std::string& value = node.as_string()->get();
  if (std::find(choices.begin(), choices.end(), value) == choices.end()) {
    node_->fail(node, join(node_->path, key), "unknown value " + in_quotes(value), alternatives(choices));
  }
  return value;
}

double Table::number(std::string_view key, Range range) const {
  return node_->number(node_->require(key, expected_number(range)), join(node_->path, key), range);
}

double Table::number_or(std::string_view key, double fallback, Range range) const {
  return has(key) ? number(key, range) : fallback;
}

double Table::limit(std::string_view key) const {
  const auto* value = node_->require(key, "a number, inf or -inf").as_floating_point();
  return value != nullptr && std::isinf(value->get()) ? value->get() : number(key);
}

std::int64_t Table::integer(std::string_view key, std::int64_t min, std::int64_t max) const {
  const std::string expected = expected_integer(min, max);
  const auto& node = node_->require(key, expected);
  if (!node.is_integer()) node_->fail(node, join(node_->path, key), found(node), expected);
  const std::int64_t value = node.as_integer()->get();
  if (value < min || value > max) {
    node_->fail(node, join(node_->path, key), std::to_string(value) + " is out of range", expected);
  }
  return value;
}

std::int64_t Table::integer_or(std::string_view key, std::int64_t fallback, std::int64_t min, std::int64_t max) const {
  return has(key) ? integer(key, min, max) : fallback;
}

bool Table::boolean_or(std::string_view key, bool fallback) const {
  const auto* node = node_->find(key);
  if (node == nullptr) return fallback;
  if (!node->is_boolean()) node_->fail(*node, join(node_->path, key), found(*node), "true or false");
  return node->as_boolean()->get();
}

std::vector<std::string> Table::texts(std::string_view key) const {
  const std::string expected = "an array of texts";
  const std::string full_key = join(node_->path, key);
  const auto& node = node_->require(key, expected);
  if (!node.is_array()) node_->fail(node, full_key, found(node), expected);
  std::vector<std::string> values;
  for (const auto& element : *node.as_array()) {
    if (!element.is_string()) node_->fail(element, full_key, found(element), expected);
    values.push_back(element.as_string()->get());
  }
  return values;
}

std::vector<double> Table::numbers(std::string_view key, std::size_t size, Range range) const {
  const std::string expected = "an array of " + (size == 0 ? "" : std::to_string(size) + " ") + "numbers";
  const std::string full_key = join(node_->path, key);
  const auto& node = node_->require(key, expected);
  const auto* array = node.as_array();
  if (array == nullptr) node_->fail(node, full_key, found(node), expected);
  if (size != 0 && array->size() != size) {
    node_->fail(node, full_key, "has " + std::to_string(array->size()) + " values", expected);
  }
  std::vector<double> values;
  for (const auto& element : *array) {
    values.push_back(node_->number(element, full_key + "[" + std::to_string(values.size()) + "]", range));
  }
  return values;
}

std::optional<std::vector<double>> Table::optional_numbers(std::string_view key, std::size_t size, Range range) const {
  return has(key) ? std::optional(numbers(key, size, range)) : std::nullopt;
}

Table Table::table(std::string_view key) const {
  const std::string full_key = join(node_->path, key);
  const std::string expected = "a table [" + full_key + "]";
  const auto& node = node_->require(key, expected);
  if (!node.is_table()) node_->fail(node, full_key, found(node), expected);
  return Table(node_->child(*node.as_table(), full_key, line(key)));
}

std::optional<Table> Table::optional_table(std::string_view key) const {
  return has(key) ? std::optional(table(key)) : std::nullopt;
}

std::vector<Table> Table::tables(std::string_view key) const {
  std::vector<Table> result;
  const auto* node = node_->find(key);
  if (node == nullptr) return result;
  const std::string full_key = join(node_->path, key);
  const std::string expected = "tables [[" + full_key + "]]";
  if (!node->is_array()) node_->fail(*node, full_key, found(*node), expected);
  for (const auto& element : *node->as_array()) {
    const std::string element_key = full_key + "[" + std::to_string(result.size()) + "]";
    if (!element.is_table()) node_->fail(element, element_key, found(element), expected);
    result.push_back(Table(node_->child(*element.as_table(), element_key, line_of(element.source()))));
  }
  return result;
}

std::vector<std::string> Table::table_names() const {
  auto names = keys();
  for (const auto& name : names) table(name);
  return names;
}

std::vector<std::string> Table::keys() const {
  std::vector<std::pair<toml::source_position, std::string>> places;
  for (const auto& [key, value] : *node_->table) places.emplace_back(key.source().begin, key.str());
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  names.reserve(places.size());
  for (auto& [place, name] : places) names.push_back(std::move(name));
  return names;
}

void Table::only(std::initializer_list<std::string_view> keys) const {
  node_->asked.insert(keys.begin(), keys.end());
  finish();
}

void Table::finish() const {
  for (const auto& name : keys()) {
    if (node_->asked.contains(name)) continue;
    const std::vector<std::string> known(node_->asked.begin(), node_->asked.end());
    node_->refuse_unknown(node_->table->find(name)->first, core::nearest_word(name, known));
  }
}

void Table::fail(std::string_view key, const std::string& problem, const std::string& expected) const {
  node_->fail(line(key), key.empty() ? node_->path : join(node_->path, key), problem, expected);
}

const std::filesystem::path& Table::file() const { return node_->document->file; }

int Table::line(std::string_view key) const {
  const auto place = node_->table->find(key);
  return key.empty() || place == node_->table->end() ? node_->header_line : line_of(place->first.source());
}

}  // namespace mrroc::config
