#pragma once

#include <cstdint>

namespace mrroc {

/// How a robot comes to rest that shares its motion with others: all of them continue on their ways and slow down
/// alike. With T = `ticks` servo periods, s = t/T and k = 2 + `rate` T, limited to -1..5, the time tau on the way runs
/// as
///   dtau/dt = (1 - s)^2 (1 + k s),   tau(T) = T (1/3 + k/12),
/// so that d2tau/dt2 is `rate` at the start and 0 at the end. The way is that of the joints with the velocity and the
/// acceleration of the start: q(tau) = q0 + v0 tau + (a0 - rate v0) tau^2 / 2. Robots that stop at the same tick keep
/// their relative poses but for terms of the third order in tau.
///
/// When one of them stops before its motion ends, for a fault, at a force limit or without a successor in time, those
/// of the same `group` on its computer stop as well, from the next servo tick on.
struct CommonStop {
  std::uint16_t ticks = 0;  ///< 0: every joint on its own, as fast as its limits allow
  double rate = 0;          ///< 1/s: relative change of the velocity along the way at the start
  std::uint64_t group = 0;  ///< names this motion of these robots, after each interruption another one; 0: no group
};

}  // namespace mrroc
