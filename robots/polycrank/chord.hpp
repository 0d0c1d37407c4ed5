#pragma once

#include <optional>

#include "robots/polycrank/planar_pair.hpp"

namespace mrroc::polycrank {

/// The points of a straight line that a pair of cranks reaches. The pair reaches a ring, so with t as the coordinate
/// along the line they are those with inner <= |t - centre| <= outer. In m. Any thread; never allocates or throws.
struct Chord {
  double centre = 0;
  double inner = 0;
  double outer = 0;

  /// Within rounding, 1e-12 m.
  bool contains(double t) const noexcept;
};

/// The chord of the line that passes the pair's first axis at `distance`, with t = `centre` where it is nearest to the
/// axis. Nothing when the line is out of reach.
std::optional<Chord> chord(const PlanarPair& pair, double centre, double distance) noexcept;

/// The t nearest to `wanted` that is in both chords; nothing when they have none in common.
std::optional<double> nearest_in_both(const Chord& one, const Chord& other, double wanted) noexcept;

}  // namespace mrroc::polycrank
