#include "config/entries/feeder_entry.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "config/entries/device_name.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

std::array<double, 3> three(const std::vector<double>& values) { return {values[0], values[1], values[2]}; }

/// `fed`: the parts of the previous feeders.
std::vector<std::string> read_parts(const Table& table, std::set<std::string>& fed) {
  std::vector<std::string> parts = table.texts("parts");
  if (parts.empty()) table.fail("parts", "empty", "at least one body of the scene");
  for (const std::string& part : parts) {
    if (!fed.insert(part).second) table.fail("parts", in_quotes(part) + " is listed twice", "each body once");
  }
  return parts;
}

std::array<double, 2> read_interval(const Table& table) {
  const std::vector<double> interval = table.numbers("interval", 2, {0.02, 1e6});
  if (interval[0] > interval[1]) {
    table.fail("interval", "from " + number_text(interval[0]) + " to " + number_text(interval[1]) + " s",
               "the shorter time first");
  }
  return {interval[0], interval[1]};
}

FeederEntry read_feeder(const Table& table, const std::string& name, std::set<std::string>& fed) {
  table.only({"parts", "position", "spread", "turn", "first", "interval", "seed"});
  FeederEntry feeder;
  feeder.name = name;
  feeder.parts = read_parts(table, fed);
  feeder.position = three(table.numbers("position", 3));
  if (const auto spread = table.optional_numbers("spread", 3, {.min = 0})) feeder.spread = three(*spread);
  feeder.turn = table.number_or("turn", 0, {.min = 0});
  feeder.first = table.number_or("first", 0, {0, 1e6});
  if (feeder.parts.size() > 1 || table.has("interval")) feeder.interval = read_interval(table);
  feeder.seed =
      static_cast<std::uint32_t>(table.integer_or("seed", feeder.seed, 0, std::numeric_limits<std::uint32_t>::max()));
  return feeder;
}

}  // namespace

std::vector<FeederEntry> read_feeders(const Table& sim) {
  std::vector<FeederEntry> feeders;
  const auto tables = sim.optional_table("feeders");
  if (!tables) return feeders;
  std::set<std::string> fed;
  for (const std::string& name : tables->table_names()) {
    check_device_name(*tables, name);
    feeders.push_back(read_feeder(tables->table(name), name, fed));
  }
  return feeders;
}

}  // namespace mrroc::config
