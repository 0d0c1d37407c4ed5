#include "cli/operator/watching/world_feed.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

Json numbers(std::span<const double> values) {
  Json array = Json::array();
  for (const double value : values) array.push_back(value);
  return array;
}

}  // namespace

void WorldFeed::watch(bool wanted) noexcept {
  if (memory_ == nullptr) return;
  const bool before = memory_->watched.exchange(wanted ? 1 : 0, std::memory_order_relaxed) != 0;
  // what was stored for the last watcher is old
  if (wanted && !before && memory_->snapshot.load(snapshot_)) taken_ = snapshot_.tick;
}

std::optional<std::string> WorldFeed::take() {
  if (memory_ == nullptr || !memory_->snapshot.load(snapshot_) || snapshot_.tick == taken_) return std::nullopt;
  taken_ = snapshot_.tick;
  const std::span<const double> values(snapshot_.values);
  const std::size_t positions = snapshot_.position_count, mocaps = snapshot_.mocap_count;
  if (positions + 7 * mocaps > values.size()) return std::nullopt;
  return Json{{"event", "world"},
              {"tick", snapshot_.tick},
              {"positions", numbers(values.first(positions))},
              {"mocap_positions", numbers(values.subspan(positions, 3 * mocaps))},
              {"mocap_quaternions", numbers(values.subspan(positions + 3 * mocaps, 4 * mocaps))}}
      .dump();
}

}  // namespace mrroc::cli
