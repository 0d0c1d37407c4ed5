#include "cli/pictures/world_event.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>

namespace mrroc::cli {

namespace {

/// Appends the array `name` of `event` to the values, of which `count` are there; false when it is missing or too long.
bool append(const nlohmann::ordered_json& event, const char* name, world::WorldSnapshot& world, std::size_t& count) {
  const auto found = event.find(name);
  if (found == event.end() || !found->is_array() || count + found->size() > world.values.size()) return false;
  for (const auto& value : *found) world.values[count++] = value.is_number() ? value.get<double>() : 0;
  return true;
}

}  // namespace

std::optional<world::WorldSnapshot> world_of_event(const nlohmann::ordered_json& event) {
  if (!event.is_object() || event.value("event", "") != "world") return std::nullopt;
  world::WorldSnapshot world{};
  std::size_t count = 0;
  if (!append(event, "positions", world, count)) return std::nullopt;
  const std::size_t positions = count;
  if (!append(event, "mocap_positions", world, count)) return std::nullopt;
  const std::size_t mocaps = (count - positions) / 3;
  if (!append(event, "mocap_quaternions", world, count) || count != positions + 7 * mocaps) return std::nullopt;
  world.tick = event.value("tick", Tick{0});
  world.position_count = static_cast<std::uint32_t>(positions);
  world.mocap_count = static_cast<std::uint32_t>(mocaps);
  return world;
}

}  // namespace mrroc::cli
