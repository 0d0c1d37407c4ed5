#pragma once

#include <array>

#include "fixture.hpp"

namespace mrroc::serial_parallel {

/// A leg's ends in the tripod frame.
struct Leg {
  Eigen::Vector3d foot, head;
  Eigen::Vector3d along() const { return head - foot; }
};

/// Legs A, B, C.
inline std::array<Leg, 3> legs_at(const Placement& placement) {
  const Pose platform = tripod().platform(placement);
  const LegPoints &base = geometry().base, &top = geometry().platform;
  return {Leg{{0, base.a, 0}, platform * Eigen::Vector3d(0, top.a, 0)},
          Leg{{base.b, 0, 0}, platform * Eigen::Vector3d(top.b, 0, 0)},
          Leg{{0, base.c, 0}, platform * Eigen::Vector3d(0, top.c, 0)}};
}

}  // namespace mrroc::serial_parallel
