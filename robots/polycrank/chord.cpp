#include "robots/polycrank/chord.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::polycrank {
namespace {

constexpr double kRounding = 1e-12;  // m

double half_chord(double radius, double distance) {
  return std::sqrt(std::max(radius * radius - distance * distance, 0.0));
}

}  // namespace

bool Chord::contains(double t) const noexcept {
  const double from_centre = std::abs(t - centre);
  return from_centre >= inner - kRounding && from_centre <= outer + kRounding;
}

std::optional<Chord> chord(const PlanarPair& pair, double centre, double distance) noexcept {
  if (!(std::abs(distance) <= pair.longest_reach() + kRounding)) return std::nullopt;
  return Chord{centre, half_chord(pair.shortest_reach(), distance), half_chord(pair.longest_reach(), distance)};
}

std::optional<double> nearest_in_both(const Chord& one, const Chord& other, double wanted) noexcept {
  // it is `wanted` itself or an end of one of the chords' intervals
  std::optional<double> nearest;
  const auto consider = [&](double t) {
    if (!one.contains(t) || !other.contains(t)) return;
    if (!nearest || std::abs(t - wanted) < std::abs(*nearest - wanted)) nearest = t;
  };
  consider(wanted);
  for (const Chord& chord : {one, other}) {
    for (const double half : {-chord.outer, -chord.inner, chord.inner, chord.outer}) consider(chord.centre + half);
  }
  return nearest;
}

}  // namespace mrroc::polycrank
