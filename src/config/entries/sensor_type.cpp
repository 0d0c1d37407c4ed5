#include "config/entries/sensor_type.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/entries/declared_keys.hpp"
#include "config/resources.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// Keys of every sensor.
constexpr std::array<std::string_view, 8> kCommonKeys{"type",   "robot",  "mode",         "rate",
                                                      "source", "replay", "frozen_after", "noise_max"};
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

constexpr double kMostPixels = 8192;  // of a side of a picture

/// After the type's own keys.
void read_pictures(const Table& type, const Table& table, SensorEntry& sensor) {
  sensor.gives_pictures = type.boolean_or("pictures", false);
  if (!sensor.gives_pictures) return;
  for (const char* key : {"width", "height"}) {
    const auto size = sensor.numbers.find(key);
    if (size == sensor.numbers.end() || size->second.size() != 1)
      type.fail("pictures", "true without the parameter " + in_quotes(key) + " of kind number", "it, in px");
    const double pixels = size->second.front();
    if (pixels != std::floor(pixels) || pixels < 1 || pixels > kMostPixels)
      table.fail(key, number_text(pixels), "a whole number of px from 1 to " + number_text(kMostPixels));
  }
}

}  // namespace

void read_sensor_type(const Table& table, SensorEntry& sensor) {
  const Table type = Table::load(type_file("sensors", sensor.type, sensor.type + ".toml"));
  sensor.channels = read_channels(type, "channels");
  sensor.raw_channels = read_channels(type, "raw_channels");
  read_sources(type, sensor);
  read_declared_keys(type, table, kCommonKeys, sensor);
  read_effector_state(type, sensor);
  sensor.gives_wrench = type.boolean_or("wrench", false);
  read_pictures(type, table, sensor);
}

}  // namespace mrroc::config
