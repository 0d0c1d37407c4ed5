#pragma once

#include <span>

namespace mrroc::vsp {

/// The reading of a range finder whose ray hits nothing.
inline constexpr double kNothingHit = -1;

/// The beam of a transducer as a fan of rays in one plane, evenly spread over its full opening b: ray i of n points
/// a_i = b (i / (n - 1) - 1/2) off the axis. One ray lies on the axis.
struct Beam {
  double opening = 0;        ///< b, rad
  double max_incidence = 0;  ///< rad; pi/2: every surface sends sound back
};

/// The nearest of the fan's ranges (m, kNothingHit where a ray meets nothing) that comes back as an echo; kNothingHit
/// without an echo. Air-borne sound at 40 kHz has a wavelength of 8.6 mm: most walls are mirrors to it, and only
/// what faces the transducer, or an edge, sends it back (R. Kuc, M. W. Siegel, "Physically based simulation model for
/// acoustic sensor robot navigation", IEEE Trans. PAMI 9(6), 1987). So a ray gives an echo where its range is a local
/// minimum of the fan: a surface at right angles or an edge; but not at the outermost ray when the surface there is
/// flat, continues inward for three rays, and is turned away by more than `max_incidence`: its edge is not in the beam.
/// With d the angle between rays, ranges r0 (outermost), r1, r2 are of one flat surface, within 1 %, when
///
///     (1/r0 + 1/r2) r1 = 2 cos d,      and its incidence at r0 is      atan((r1 cos d - r0) / (r1 sin d))
///
/// A wall turned by more than b/2 + max_incidence out of the axis' normal plane is not seen at all.
/// Any thread; allocates nothing, never throws.
double nearest_echo(std::span<const double> ranges, const Beam& beam) noexcept;

}  // namespace mrroc::vsp
