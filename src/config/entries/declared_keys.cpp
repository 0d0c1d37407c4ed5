#include "config/entries/declared_keys.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

constexpr std::int64_t kMostNumbers = 1000;

/// The values that the keys of one declaration allow.
struct Declaration {
  std::string kind;
  std::size_t size = 0;
  Range range;
  std::vector<std::string> choices;
};

Range read_range(const Table& table) {
  Range range;
  range.min = table.number_or("min", range.min);
  range.max = table.number_or("max", range.max);
  if (range.max < range.min) {
    table.fail("max", number_text(range.max) + " is below min", expected_number({.min = range.min}));
  }
  return range;
}

Declaration read_declaration(const Table& table) {
  Declaration declaration;
  declaration.kind = table.choice("kind", {"number", "numbers", "integer", "boolean", "text"});
  if (declaration.kind == "numbers") {
    declaration.size = static_cast<std::size_t>(table.integer_or("size", 0, 1, kMostNumbers));
  }
  if (declaration.kind == "text") {
    if (table.has("choices")) declaration.choices = table.texts("choices");
  } else if (declaration.kind != "boolean") {
    declaration.range = read_range(table);
  }
  table.optional_text("unit");
  table.optional_text("text");
  table.has("default");
  table.finish();
  return declaration;
}

/// Bounds of an integer that a double holds exactly.
std::int64_t bound(double value) {
  constexpr double kMost = 9007199254740992.0;
  return static_cast<std::int64_t>(std::clamp(std::ceil(value), -kMost, kMost));
}

/// Value `from_key` of `from` becomes the value of `key`.
void read_value(const Declaration& declaration, const Table& from, std::string_view from_key, const std::string& key,
                KeyValues& values) {
  if (declaration.kind == "text") {
    values.texts[key] = declaration.choices.empty() ? from.text(from_key) : from.choice(from_key, declaration.choices);
  } else if (declaration.kind == "number") {
    values.numbers[key] = {from.number(from_key, declaration.range)};
  } else if (declaration.kind == "integer") {
    const std::int64_t whole = from.integer(from_key, bound(declaration.range.min), bound(declaration.range.max));
    values.numbers[key] = {static_cast<double>(whole)};
  } else if (declaration.kind == "boolean") {
    if (!from.has(from_key)) from.text(from_key);  // the error of a missing key
    values.numbers[key] = {from.boolean_or(from_key, false) ? 1.0 : 0.0};
  } else {
    values.numbers[key] = from.numbers(from_key, declaration.size, declaration.range);
  }
}

}  // namespace

void read_declared_keys(const Table& type, const Table& table, std::span<const std::string_view> reserved,
                        KeyValues& values) {
  const auto parameters = type.optional_table("parameters");
  if (!parameters) return;
  for (const auto& key : parameters->table_names()) {
    if (std::find(reserved.begin(), reserved.end(), key) != reserved.end())
      parameters->fail(key, "every table of this kind has this key", "a key of the type's own");
    const Table declared = parameters->table(key);
    const Declaration declaration = read_declaration(declared);
    if (declared.has("default")) read_value(declaration, declared, "default", key, values);
    if (table.has(key) || !declared.has("default")) read_value(declaration, table, key, key, values);
  }
}

}  // namespace mrroc::config
