#include "config/entries/sensor_type.hpp"

#include <algorithm>
#include <array>

#include "config/resources.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// Keys of every sensor.
constexpr std::array<std::string_view, 8> kCommonKeys{"type",   "robot",  "mode",         "rate",
                                                      "source", "replay", "frozen_after", "noise_max"};
constexpr std::int64_t kMostNumbers = 1000;

/// The values that the keys of one declaration allow.
struct Declaration {
  std::string kind;
  std::size_t size = 0;
  Range range;
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
  declaration.kind = table.choice("kind", {"number", "numbers", "text"});
  if (declaration.kind == "numbers") {
    declaration.size = static_cast<std::size_t>(table.integer_or("size", 0, 1, kMostNumbers));
  }
  if (declaration.kind != "text") declaration.range = read_range(table);
  table.optional_text("unit");
  table.optional_text("text");
  table.has("default");
  table.finish();
  return declaration;
}

/// Value `from_key` of `from` becomes the sensor's parameter `key`.
void read_value(const Declaration& declaration, const Table& from, std::string_view from_key, const std::string& key,
                SensorEntry& sensor) {
  if (declaration.kind == "text") {
    sensor.texts[key] = from.text(from_key);
  } else if (declaration.kind == "number") {
    sensor.numbers[key] = {from.number(from_key, declaration.range)};
  } else {
    sensor.numbers[key] = from.numbers(from_key, declaration.size, declaration.range);
  }
}

void read_own_parameters(const Table& type, const Table& table, SensorEntry& sensor) {
  const auto parameters = type.optional_table("parameters");
  if (!parameters) return;
  for (const auto& key : parameters->table_names()) {
    if (std::find(kCommonKeys.begin(), kCommonKeys.end(), key) != kCommonKeys.end()) {
      parameters->fail(key, "every sensor has this key", "a key of the type's own");
    }
    const Table declared = parameters->table(key);
    const Declaration declaration = read_declaration(declared);
    // the default is read even when it is not needed, so that a wrong one is reported early
    if (declared.has("default")) read_value(declaration, declared, "default", key, sensor);
    if (table.has(key) || !declared.has("default")) read_value(declaration, table, key, key, sensor);
  }
}

std::vector<Channel> read_channels(const Table& type, const char* kind) {
  std::vector<Channel> channels;
  if (!type.has(kind)) return channels;
  for (const Table& table : type.tables(kind)) {
    channels.push_back({table.text("name"), table.text("unit")});
    const std::string& name = channels.back().name;
    const auto same = [&name](const Channel& channel) { return channel.name == name; };
    if (std::any_of(channels.begin(), channels.end() - 1, same))
      table.fail("name", in_quotes(name) + " is the name of an earlier channel", "a unique name");
    table.finish();
  }
  return channels;
}

void read_sources(const Table& type, SensorEntry& sensor) {
  if (!type.has("sources")) return;
  sensor.sources = type.texts("sources");
  for (const std::string& source : sensor.sources) {
    if (source != "simulated" && source != "replay" && source != "hardware")
      type.fail("sources", "unknown source " + in_quotes(source), alternatives({"simulated", "replay", "hardware"}));
  }
  if (sensor.sources.empty()) type.fail("sources", "none", "at least one");
  sensor.source = sensor.sources.front();
}

/// After the type's own keys.
void read_effector_state(const Table& type, SensorEntry& sensor) {
  sensor.wants_effector_state = type.boolean_or("effector_state", false);
  const auto key = type.optional_text("effector_state_with");
  if (!key) return;
  const auto number = sensor.numbers.find(*key);
  if (number == sensor.numbers.end() || number->second.size() != 1)
    type.fail("effector_state_with", in_quotes(*key) + " is not a parameter of kind number", "one of this file");
  sensor.wants_effector_state = sensor.wants_effector_state || number->second[0] != 0;
}

}  // namespace

void read_sensor_type(const Table& table, SensorEntry& sensor) {
  const Table type = Table::load(type_file("sensors", sensor.type, sensor.type + ".toml"));
  sensor.channels = read_channels(type, "channels");
  sensor.raw_channels = read_channels(type, "raw_channels");
  read_sources(type, sensor);
  read_own_parameters(type, table, sensor);
  read_effector_state(type, sensor);
}

}  // namespace mrroc::config
