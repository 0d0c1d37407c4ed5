#include "sensors/ultrasonic/beam.hpp"

#include <cmath>
#include <limits>

namespace mrroc::vsp {

namespace {

constexpr double kFlatness = 0.01;  // of 1; the next surface behind an edge is off by far more

double distance_of(double range) noexcept { return range < 0 ? std::numeric_limits<double>::infinity() : range; }

bool is_local_minimum(std::span<const double> ranges, std::size_t i) noexcept {
  const double range = distance_of(ranges[i]);
  if (i > 0 && distance_of(ranges[i - 1]) < range) return false;
  return i + 1 == ranges.size() || range <= distance_of(ranges[i + 1]);
}

/// Whether the outermost ray `r0` meets a flat surface that mirrors the sound away; `r1`, `r2` are the next two inward.
bool is_mirrored_away(double r0, double r1, double r2, double angle, double max_incidence) noexcept {
  if (r1 <= 0 || r2 <= 0 || r0 <= 0) return false;
  const bool flat = std::abs((1 / r0 + 1 / r2) * r1 / (2 * std::cos(angle)) - 1) < kFlatness;
  return flat && std::atan2(r1 * std::cos(angle) - r0, r1 * std::sin(angle)) > max_incidence;
}

bool sends_back(std::span<const double> ranges, std::size_t i, const Beam& beam) noexcept {
  if (!is_local_minimum(ranges, i)) return false;
  const std::size_t n = ranges.size();
  const bool first = i == 0, last = i + 1 == n;
  if (n < 3 || !(first || last)) return true;
  const double angle = beam.opening / static_cast<double>(n - 1);
  return first ? !is_mirrored_away(ranges[0], ranges[1], ranges[2], angle, beam.max_incidence)
               : !is_mirrored_away(ranges[i], ranges[i - 1], ranges[i - 2], angle, beam.max_incidence);
}

}  // namespace

double nearest_echo(std::span<const double> ranges, const Beam& beam) noexcept {
  double nearest = kNothingHit;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges[i] < 0 || (nearest >= 0 && ranges[i] >= nearest)) continue;
    if (sends_back(ranges, i, beam)) nearest = ranges[i];
  }
  return nearest;
}

}  // namespace mrroc::vsp
