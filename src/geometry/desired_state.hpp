#pragma once

#include "mrroc/types.hpp"

namespace mrroc {

/// The set-point and its motion: joints, their velocities and accelerations (rad or m, per s, per s^2).
struct DesiredState {
  JointVector position;
  JointVector velocity;
  JointVector acceleration;

  /// Nothing moves: exactly zero, because commands and stops that come to rest do so exactly.
  bool at_rest() const noexcept { return (velocity.array() == 0.0).all() && (acceleration.array() == 0.0).all(); }

  static DesiredState resting_at(const JointVector& position) noexcept {
    return {position, JointVector::Zero(position.size()), JointVector::Zero(position.size())};
  }
};

}  // namespace mrroc
