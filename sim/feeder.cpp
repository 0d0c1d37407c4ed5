#include "sim/feeder.hpp"

#include <cmath>

namespace mrroc::sim {

Feeder::Feeder(const config::FeederEntry& entry, World& world, double period)
    : entry_(entry), period_(period), random_(entry.seed), next_(ticks(entry.first)) {
  for (const std::string& part : entry.parts) {
    parts_.push_back(world.hold(part, "sim.feeders." + entry.name + ".parts"));
  }
}

void Feeder::feed(World& world, Tick tick) {
  if (fed_ == parts_.size() || tick < next_) return;
  world.put(parts_[fed_++], next_place());
  next_ += ticks(uniform(entry_.interval[0], entry_.interval[1]));
}

Tick Feeder::ticks(double seconds) const noexcept { return static_cast<Tick>(std::llround(seconds / period_)); }

/// Not std::uniform_real_distribution, whose numbers are the library's own.
double Feeder::uniform(double from, double to) noexcept {
  return from + (to - from) * (static_cast<double>(random_()) / 4294967296.0);
}

Pose Feeder::next_place() noexcept {
  Eigen::Vector3d place;
  for (std::size_t i = 0; i < 3; ++i) {
    place[static_cast<Eigen::Index>(i)] = entry_.position[i] + uniform(-entry_.spread[i], entry_.spread[i]);
  }
  return Eigen::Translation3d(place) * Eigen::AngleAxisd(uniform(-entry_.turn, entry_.turn), Eigen::Vector3d::UnitZ()) *
         Pose::Identity();
}

}  // namespace mrroc::sim
